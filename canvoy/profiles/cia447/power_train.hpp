// CiA 447-3, clause 4.2.4: what the IVN gateway reports of engine, gear, wheels and fuel, and
// accepts for cruise control and four-wheel drive.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.4.1 to 4.2.4.3: engine and gear. Revolutions, wheel rpm and wheel pulses are sent every 100
// ms.

inline constexpr auto terminal_states =
    status_values<2>("Terminal 61 not active", "Terminal 61 active");
inline constexpr auto actual_engine_revolutions_fields =
    side_by_side(field(14, "actual engine revolutions", "speed of the engine",
                       measured<14>(Unit::revolution_per_minute)),
                 field(2, "t61", "terminal 61", terminal_states));
inline constexpr auto actual_engine_revolutions_object = variable_object(
    0x6050, "Actual engine revolutions", "4.2.4.1", "Speed of the engine, sent each 100 ms.",
    status(DataType::unsigned16, Mapping::by_default, actual_engine_revolutions_fields));

inline constexpr auto engine_states =
    status_values<8>("Engine is off", "Engine is ready", "Engine is cranking", "Engine is running",
                     "Engine is stalled", "After run", "Shutdown");
inline constexpr auto engine_status_object = variable_object(
    0x6051, "Engine status", "4.2.4.2", "What the engine does.",
    status(DataType::unsigned8, Mapping::by_default, ValueInfo{.names = engine_states}));

inline constexpr auto selector_lever_positions =
    status_values<4>("Intermediate position", "Position 1", "Position 2", "Position 3",
                     "Position 4", "Normal driving position automatic (D)",
                     "Neutral position automatic (N)", "Reverse position automatic (R)",
                     "Parking position automatic (P)/Key lock release", "Position L (low)");
inline constexpr auto automatic_gear_modes =
    status_values<3>("Manual", "Sport", "Comfort", "Winter");
inline constexpr auto engagement = status_values<2>("Disengaged", "Engaged");
inline constexpr auto gears =
    status_values<4>("No gear", "1st gear", "2nd gear", "3rd gear", "4th gear", "5th gear",
                     "6th gear", "7th gear", "8th gear", "Reverse gear");
inline constexpr auto transmission_selector_lever_position_fields = side_by_side(
    field(4, "selector lever position", "where the lever stands", selector_lever_positions),
    field(3, "agm", "automatic gear mode", automatic_gear_modes),
    field(2, "pb", "parking brake", engagement), field(2, "cs", "coupling switch", engagement),
    field(4, "engaged gear", "the gear that is in", gears), reserved<1>());
inline constexpr auto transmission_selector_lever_position_object = variable_object(
    0x6052, "Transmission selector lever position", "4.2.4.3", "Selector lever, gear and brake.",
    status(DataType::unsigned16, Mapping::no, transmission_selector_lever_position_fields));

// 4.2.4.4 to 4.2.4.8: wheels.

inline constexpr auto wheel_rpm_object = variable_object(
    0x6053, "Wheel rpm", "4.2.4.4",
    "Speed of the wheels, sent each 100 ms; true to 1 % above 3 km/h, and at most 500 ms late.",
    status(DataType::unsigned16, Mapping::by_default,
           measured<16, 0x3FFE>(Unit::revolution_per_minute, {.denominator = 2})),
    {.errata = "D8"});

inline constexpr auto wheel_signal_sources =
    status_values<8>("Front right wheel", "Front left wheel", "Rear right wheel", "Rear left wheel",
                     "Average front wheels", "Average rear wheels", "Average all wheels");
inline constexpr auto wheel_signal_source_object = variable_object(
    0x6054, "Wheel signal source", "4.2.4.5",
    "Which wheels are measured; a change out of service mode may be a taximeter error.",
    status(DataType::unsigned8, Mapping::no, ValueInfo{.names = wheel_signal_sources}),
    {.errata = "D8"});

/// All values of 16 bits are legal counts (errata C5). Another entry says whether they are valid.
inline constexpr ValueInfo pulses = {.limits = within(0, 0xFFFF)};
inline constexpr auto wheel_pulse_counter_fields =
    side_by_side(field(16, "wheel pulse counter", "pulses; where it overruns is in 6056h", pulses),
                 field(2, "pcvalid", "pulse counter valid", no_yes), reserved<6>());
inline constexpr auto wheel_pulse_counter_object = variable_object(
    0x6055, "Wheel pulse counter", "4.2.4.6",
    "Pulses of the wheels, sent each 100 ms; at most 1.8 % (or 16 m) wrong, 500 ms late.",
    status(DataType::unsigned24, Mapping::by_default, wheel_pulse_counter_fields),
    {.errata = "C5, D8"});
inline constexpr auto wheel_pulse_counter_overrun_value_fields = side_by_side(
    field(16, "wheel pulse counter overrun value", "where the counter in 6055h overruns", pulses),
    field(2, "valid", "whether the value is known", no_yes), reserved<6>());
inline constexpr auto wheel_pulse_counter_overrun_value_object = variable_object(
    0x6056, "Wheel pulse counter overrun value", "4.2.4.7",
    "Where the wheel pulse counter overruns.",
    status(DataType::unsigned24, Mapping::no, wheel_pulse_counter_overrun_value_fields),
    {.errata = "C5, D8"});

inline constexpr NamedValue pulse_number_names[] = {
    status_sentinels<8>.second_highest, status_sentinels<8>.highest, reserved_codes(0, 0)};
inline constexpr auto pulses_per_wheel_rotation_object =
    variable_object(0x6057, "Pulses per wheel rotation", "4.2.4.8",
                    "How many wheel pulses a rotation has: more than 20 (4.2.4.6).",
                    status(DataType::unsigned8, Mapping::no,
                           ValueInfo{.limits = within(0x01, 0xFD), .names = pulse_number_names}),
                    {.errata = "A10, D8"});

// 4.2.4.9 and 4.2.4.10. The local distance unit is in 60DAh sub-index 09h (errata C9).

inline constexpr auto displayed_vehicle_speed_object = variable_object(
    0x605A, "Displayed vehicle speed", "4.2.4.9",
    "Speed as the driver sees it, without attenuation.",
    status(DataType::unsigned16, Mapping::no,
           measured<16, 0x0FFE>(Unit::local_distance_per_hour, {.denominator = 10})),
    {.errata = "C9"});

inline constexpr NamedValue odometer_names[] = {
    {0xFF'FFFE, "Signal is not valid", Meaning::failure},
    status_sentinels<24>.highest,
    reserved_codes(0x98'9680, 0xFF'FFFD)};
inline constexpr ValueInfo mileage = {.unit = Unit::local_distance,
                                      .scale = {.denominator = 10},
                                      .limits = within(0, 0x98'967F),
                                      .names = odometer_names};
inline constexpr auto odometer_object =
    variable_object(0x605B, "Odometer", "4.2.4.10", "Mileage, as the driver sees it.",
                    status(DataType::unsigned24, Mapping::no, mileage), {.errata = "A13, C9, D8"});

// 4.2.4.11 and 4.2.4.12: fuel.

inline constexpr auto tank_minimum =
    status_values<2>("Tank level minimum not reached", "Tank level minimum reached");
inline constexpr auto tank_status_fields =
    side_by_side(field(8, "tank level", "fuel in the tank", measured<8, 0xC8>(Unit::litre)),
                 field(2, "tlm", "tank level minimum", tank_minimum), reserved<1, 6>());
inline constexpr auto tank_status_object =
    variable_object(0x605C, "Tank status", "4.2.4.11", "Fuel in the tank.",
                    status(DataType::unsigned16, Mapping::no, tank_status_fields),
                    {.category = Category::optional, .errata = "A2, A16"});

inline constexpr auto consumption_overflow =
    status_values<2>("No fuel consumption overflow", "Fuel consumption overflow");
inline constexpr auto fuel_units = status_values<2>("Liter", "Kilogram");
inline constexpr auto current_average_fuel_consumption_fields =
    side_by_side(field(16, "current average fuel consumption", "in the unit that fsu says",
                       measured<16, 0x7F00>(Unit::fuel_unit_per_second, {.denominator = 1000})),
                 field(2, "fco", "fuel consumption overflow", consumption_overflow),
                 field(2, "fsu", "fuel specific unit", fuel_units), reserved<12>());
inline constexpr auto current_average_fuel_consumption_object = variable_object(
    0x605D, "Current average fuel consumption", "4.2.4.12",
    "Fuel that the engine takes, in litres or kilograms a second.",
    status(DataType::unsigned32, Mapping::no, current_average_fuel_consumption_fields),
    {.errata = "A3, D11"});

// 4.2.4.13 to 4.2.4.16: cruise control, four-wheel drive.

/// Fields of the cruise control.
constexpr auto cruise_control(Items<NamedValue> control, Items<NamedValue> acceleration,
                              Items<NamedValue> store, Items<NamedValue> distance) {
  return side_by_side(field(2, "acc", "automatic cruise control", control),
                      field(2, "ad", "accelerate/decelerate", acceleration),
                      field(3, "store", "stored speed", store),
                      field(2, "dcs", "distance control system", distance), reserved<1, 7>());
}
inline constexpr auto cruise_commands =
    command_values<2>("Cruise control off", "Cruise control on");
inline constexpr auto acceleration_commands = command_values<2>("+ accelerate", "- decelerate");
inline constexpr auto stored_speed_commands =
    command_values<3>("Store current speed", "Store current speed as maximum",
                      "Release stored speed", "Recall last stored speed");
inline constexpr auto distance_control_commands =
    command_values<2>("Deactivate the function (turn-off)", "Activate the function (turn-on)");
inline constexpr auto cruise_control_command_fields = cruise_control(
    cruise_commands, acceleration_commands, stored_speed_commands, distance_control_commands);
inline constexpr auto cruise_control_command_object =
    variable_object(0x6060, "Automatic cruise control and distance control command", "4.2.4.13",
                    "Sets cruise control and distance control.",
                    command(DataType::unsigned16, cruise_control_command_fields),
                    {.category = Category::optional, .errata = "A16, C12"});

// There is no code for "neither" (errata C1).
inline constexpr auto cruise_states = status_values<2>("Cruise control off", "Cruise control on");
inline constexpr auto acceleration_states = status_values<2>("+ accelerating", "- decelerating");
inline constexpr auto stored_speed_states =
    status_values<3>("Current speed is stored", "Current speed is stored as maximum",
                     "Stored speed released", "Last stored speed recalled");
inline constexpr auto distance_control_states =
    status_values<2>("The function is turned-off", "The function is turned-on");
inline constexpr auto cruise_control_status_fields = cruise_control(
    cruise_states, acceleration_states, stored_speed_states, distance_control_states);
inline constexpr auto cruise_control_status_object =
    variable_object(0x6061, "Automatic cruise control and distance control status", "4.2.4.14",
                    "What cruise control and distance control do.",
                    status(DataType::unsigned16, Mapping::no, cruise_control_status_fields),
                    {.category = Category::optional, .errata = "A16, C1, C12"});

inline constexpr auto four_wheel_commands =
    command_values<2>("Switch four-wheel drive off", "Switch four-wheel drive on");
inline constexpr auto four_wheel_drive_command_fields =
    side_by_side(field(2, "four-wheel drive", "switch", four_wheel_commands), reserved<1, 6>());
inline constexpr auto four_wheel_drive_command_object =
    variable_object(0x6062, "Four-wheel drive command", "4.2.4.15", "Switches four-wheel drive.",
                    command(DataType::unsigned8, four_wheel_drive_command_fields), optional_object);
inline constexpr auto four_wheel_states = status_values<2>(
    "Four-wheel drive function is switched off", "Four-wheel drive function is switched on");
inline constexpr auto four_wheel_drive_status_fields =
    side_by_side(field(2, "four-wheel drive", "switch", four_wheel_states), reserved<1, 6>());
inline constexpr auto four_wheel_drive_status_object = variable_object(
    0x6063, "Four-wheel drive status", "4.2.4.16", "Whether four-wheel drive is on.",
    status(DataType::unsigned8, Mapping::no, four_wheel_drive_status_fields), optional_object);

}  // namespace canvoy::cia447
