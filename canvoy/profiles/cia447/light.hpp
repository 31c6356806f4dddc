// CiA 447-3, clause 4.2.3: what the IVN gateway reports and accepts for the car's lights and
// signals.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.3.1 and 4.2.3.2. The figure of the fields is lost. They are in the order of the table, from
// bit 0 upward, as nearly everywhere (errata B1).

/// Fields of the lights outside.
constexpr auto car_lights(Items<NamedValue> values) {
  return side_by_side(
      field(2, "dtrl", "day time running light", values), field(2, "bl", "brake light", values),
      field(2, "rdl", "reverse driving light", values), field(2, "hb", "high beam", values),
      field(2, "lb", "low beam", values), field(2, "flf", "fog lamps front", values),
      field(2, "flr", "fog lamps rear", values), field(2, "tir", "turn indication right", values),
      field(2, "til", "turn indication left", values),
      field(2, "ttir", "tip turn indication right", values),
      field(2, "ttil", "tip turn indication left", values),
      field(2, "ef", "emergency flasher", values), field(2, "fl", "flashing light", values),
      field(2, "pl", "position lamps", values), field(2, "plr", "parking lamps right", values),
      field(2, "pll", "parking lamps left", values));
}
inline constexpr auto off_on_states = status_values<2>("Off", "On");
inline constexpr auto light_commands =
    command_values<2>("Switch the light off", "Switch the light on");
inline constexpr auto car_light_status_fields = car_lights(off_on_states);
inline constexpr auto car_light_status_object =
    variable_object(0x6040, "Car light status", "4.2.3.1", "Which lights outside are on.",
                    status(DataType::unsigned32, Mapping::by_default, car_light_status_fields),
                    {.errata = "B1, C12"});
inline constexpr auto car_light_command_fields = car_lights(light_commands);
inline constexpr auto car_light_command_object =
    variable_object(0x6044, "Car light command", "4.2.3.2", "Switches lights outside.",
                    command(DataType::unsigned32, car_light_command_fields), {.errata = "B1, C12"});

// 4.2.3.3 and 4.2.3.4: interior light.

/// Fields of the lights inside.
constexpr auto interior_lights(Items<NamedValue> interior, Items<NamedValue> others) {
  return side_by_side(field(3, "ii", "interior illumination", interior),
                      field(2, "lrid", "leg room illumination driver", others),
                      field(2, "lrifp", "leg room illumination front passenger", others),
                      field(2, "lrirr", "leg room illumination rear right", others),
                      field(2, "lrirl", "leg room illumination rear left", others),
                      field(2, "bli", "boot lid illumination", others), reserved<1, 3>());
}
inline constexpr auto interior_illumination_states =
    status_values<3>("Off", "On dimmed", "On undimmed");
inline constexpr auto interior_illumination_commands =
    command_values<3>("Off", "On dimmed", "On undimmed");
inline constexpr auto off_on_commands = command_values<2>("Off", "On");
inline constexpr auto car_interior_light_status_fields =
    interior_lights(interior_illumination_states, off_on_states);
inline constexpr auto car_interior_light_status_object = variable_object(
    0x6045, "Car interior light status", "4.2.3.3", "Which lights inside are on.",
    status(DataType::unsigned16, Mapping::no, car_interior_light_status_fields), {.errata = "A12"});
inline constexpr auto car_interior_light_command_fields =
    interior_lights(interior_illumination_commands, off_on_commands);
inline constexpr auto car_interior_light_command_object =
    variable_object(0x6046, "Car interior light command", "4.2.3.4", "Switches lights inside.",
                    command(DataType::unsigned16, car_interior_light_command_fields));

// 4.2.3.5 and 4.2.3.6. Code 1 has different meanings in status and command (errata C4).

inline constexpr auto anti_theft_states =
    status_values<3>("Disabled", "Pre-active", "Active", "Triggered");
inline constexpr auto anti_theft_warning_system_status_fields = side_by_side(
    field(3, "anti theft warning system", "state of the alarm", anti_theft_states), reserved<5>());
inline constexpr auto anti_theft_warning_system_status_object = variable_object(
    0x6047, "Anti theft warning system status", "4.2.3.5", "State of the alarm.",
    status(DataType::unsigned8, Mapping::by_default, anti_theft_warning_system_status_fields),
    {.category = Category::optional, .errata = "A16, C4"});
inline constexpr auto anti_theft_commands =
    command_values<3>("Disable", "Do not trigger", "Activate", "Trigger");
inline constexpr auto anti_theft_warning_system_command_fields = side_by_side(
    field(3, "anti theft warning system", "what the alarm is to do", anti_theft_commands),
    reserved<5>());
inline constexpr auto anti_theft_warning_system_command_object = variable_object(
    0x6048, "Anti theft warning system command", "4.2.3.6", "Arms and fires the alarm.",
    command(DataType::unsigned8, anti_theft_warning_system_command_fields),
    {.category = Category::optional, .errata = "A16, C4"});

// 4.2.3.7 to 4.2.3.9: mirror and horn.

inline constexpr auto mirror_anti_dazzle_position_object = variable_object(
    0x6049, "Mirror anti-dazzle position", "4.2.3.7", "How far the mirror is dimmed.",
    status(DataType::unsigned8, Mapping::by_default, measured<8, 100>(Unit::percent)),
    optional_object);
inline constexpr auto horn_states = status_values<2>("Not active", "Active");
inline constexpr auto horn_status_fields =
    side_by_side(field(2, "horn status", "whether the horn sounds", horn_states), reserved<6>());
inline constexpr auto horn_status_object =
    variable_object(0x604A, "Horn status", "4.2.3.8", "Whether the horn sounds.",
                    status(DataType::unsigned8, Mapping::by_default, horn_status_fields));
inline constexpr auto horn_commands = command_values<2>("Horn off command", "Horn on command");
inline constexpr auto horn_command_fields = side_by_side(
    field(2, "horn command", "whether the horn is to sound", horn_commands), reserved<6>());
inline constexpr auto horn_command_object =
    variable_object(0x604B, "Horn command", "4.2.3.9", "Sounds the horn.",
                    command(DataType::unsigned8, horn_command_fields), optional_object);

// 4.2.3.10 and 4.2.3.11: lights of the car that flash along with the roof bar.

/// Fields of the lights that flash as a signal.
constexpr auto flashing_lights(Items<NamedValue> values) {
  return side_by_side(
      field(2, "gclf", "gateway coded light functions", values),
      field(2, "fld", "fog lamps day", values), field(2, "fln", "fog lamps night", values),
      field(2, "hbd", "high beam day", values), field(2, "hbn", "high beam night", values),
      field(2, "lbd", "low beam day", values), field(2, "lbn", "low beam night", values),
      field(2, "dtrld", "day time running light day", values),
      field(2, "dtrln", "day time running light night", values), reserved<2, 7>());
}
inline constexpr auto flashing_light_commands =
    command_values<2>("Disable function", "Enable function");
inline constexpr auto flashing_light_states =
    status_values<2>("Function is turned off", "Function is turned on");
inline constexpr auto flashing_light_command_fields = flashing_lights(flashing_light_commands);
inline constexpr auto flashing_light_command_object = variable_object(
    0x604C, "Flashing light command", "4.2.3.10",
    "Lets lights of the car flash while the roof bar does; which, a tester may configure.",
    command(DataType::unsigned32, flashing_light_command_fields),
    {.category = Category::optional, .errata = "A16, C7, D3"});
inline constexpr auto flashing_light_status_fields = flashing_lights(flashing_light_states);
inline constexpr auto flashing_light_status_object =
    variable_object(0x604D, "Flashing light status", "4.2.3.11",
                    "Which lights of the car flash while the roof bar does.",
                    status(DataType::unsigned32, Mapping::no, flashing_light_status_fields),
                    {.category = Category::optional, .errata = "A16, C7, D3"});

}  // namespace canvoy::cia447
