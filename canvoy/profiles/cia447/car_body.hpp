// CiA 447-3, clause 4.2.2: what the IVN gateway, between the CANopen network and the car's own
// networks, reports and accepts for the car's body: locks, windows, doors, seats, wipers, climate,
// occupants.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.2.1 to 4.2.2.5: illumination of switches, ignition, central locking.

inline constexpr auto switch_illumination_level_status_object = variable_object(
    0x6005, "Switch illumination level status", "4.2.2.1",
    "Background illumination of the dashboard.",
    status(DataType::unsigned8, Mapping::by_default, measured<8, 100>(Unit::percent)));
inline constexpr auto switch_illumination_level_command_object =
    variable_object(0x6006, "Switch illumination level command", "4.2.2.2",
                    "Background illumination of the dashboard that is wanted.",
                    command(DataType::unsigned8, wanted<8, 100>(Unit::percent)));

inline constexpr auto ignition_lock =
    status_values<2>("Ignition not locked", "Ignition locked (Key in)");
inline constexpr auto ignition_accessory =
    status_values<2>("No ignition accessory", "Ignition accessory");
inline constexpr auto ignition_on = status_values<2>("Ignition off", "Ignition on");
inline constexpr auto ignition_start = status_values<2>("No ignition start", "Ignition start");
inline constexpr auto ignition_switch_status_fields =
    side_by_side(field(2, "ignition lock", "key in the lock", ignition_lock),
                 field(2, "accessory", "ignition for accessories", ignition_accessory),
                 field(2, "ignition on", "ignition", ignition_on),
                 field(2, "ignition start", "starting the engine", ignition_start));
inline constexpr auto ignition_switch_status_object = variable_object(
    0x6007, "Ignition switch status", "4.2.2.3", "Where the ignition key stands.",
    status(DataType::unsigned8, Mapping::by_default, ignition_switch_status_fields));

inline constexpr auto locking_states =
    status_values<4>("Vehicle unlocked", "Vehicle internal locked", "Vehicle external locked",
                     "Vehicle selective unlocked");
inline constexpr auto central_locking_system_status_fields =
    side_by_side(field(4, "central locking system status", "how the car is locked", locking_states),
                 reserved<4>());
inline constexpr auto central_locking_system_status_object = variable_object(
    0x6009, "Central locking system status", "4.2.2.4", "How the car is locked.",
    status(DataType::unsigned8, Mapping::by_default, central_locking_system_status_fields),
    {.errata = "C10"});

inline constexpr auto locking_commands = command_values<4>(
    "Unlock vehicle", "Lock vehicle internal", "Lock vehicle external", "Unlock vehicle selective");
inline constexpr auto central_locking_system_command_fields = side_by_side(
    field(4, "central locking system command", "how to lock the car", locking_commands),
    reserved<4>());
inline constexpr auto central_locking_system_command_object = variable_object(
    0x600A, "Central locking system command", "4.2.2.5", "Locks and unlocks the car.",
    command(DataType::unsigned8, central_locking_system_command_fields));

// 4.2.2.6 to 4.2.2.9: windows and doors: 0 is open (errata C2).

inline constexpr auto opening_states =
    status_values<3>("Open", "Closed", "Is getting open", "Is getting closed");
inline constexpr auto window_commands = command_values<2>("Open the window", "Close the window");
inline constexpr auto door_commands = command_values<2>("Open the door", "Close the door");

/// Fields of the six windows.
constexpr auto windows(unsigned bits, Items<NamedValue> values) {
  return side_by_side(field(bits, "wd", "window driver", values),
                      field(bits, "wfp", "window front passenger", values),
                      field(bits, "wrr", "window rear right", values),
                      field(bits, "wrl", "window rear left", values),
                      field(bits, "w3rr", "window 3rd row right", values),
                      field(bits, "w3rl", "window 3rd row left", values));
}
/// Fields of the four doors.
constexpr auto doors(unsigned bits, Items<NamedValue> values) {
  return side_by_side(
      field(bits, "dd", "door driver", values), field(bits, "dfp", "door front passenger", values),
      field(bits, "drr", "door rear right", values), field(bits, "drl", "door rear left", values));
}

inline constexpr auto window_status_fields =
    side_by_side(windows(3, opening_states), reserved<6>());
inline constexpr auto window_status_object = variable_object(
    0x600B, "Window status", "4.2.2.6", "Which windows are open.",
    status(DataType::unsigned24, Mapping::by_default, window_status_fields), {.errata = "C2"});
inline constexpr auto window_command_fields =
    side_by_side(windows(2, window_commands), reserved<4>());
inline constexpr auto window_command_object =
    variable_object(0x600C, "Window command", "4.2.2.7", "Opens and closes windows.",
                    command(DataType::unsigned16, window_command_fields), {.errata = "C2"});
inline constexpr auto door_status_fields = side_by_side(doors(3, opening_states), reserved<4>());
inline constexpr auto door_status_object = variable_object(
    0x600D, "Door status", "4.2.2.8", "Which doors are open.",
    status(DataType::unsigned16, Mapping::by_default, door_status_fields), {.errata = "C2, C10"});
inline constexpr auto door_command_fields = doors(2, door_commands);
inline constexpr auto door_command_object =
    variable_object(0x600E, "Door command", "4.2.2.9", "Opens and closes doors.",
                    command(DataType::unsigned8, door_command_fields), {.errata = "C2"});

// 4.2.2.10 and 4.2.2.11: flaps and roofs: 0 is closed (errata C2). The fields are in the order of
// the figures (errata C8).

inline constexpr auto flap_states =
    status_values<3>("Closed", "Open", "Is getting closed", "Is getting open");
inline constexpr auto top_states =
    status_values<3>("Closed", "Open", "Is getting closed", "Is getting open", "Stopped");
inline constexpr auto sliding_roof_states =
    status_values<4>("Closed", "Open (tilt)", "Open (slide)", "Is getting closed (tilt)",
                     "Is getting closed (slide)", "Is getting open (tilt)",
                     "Is getting open (slide)", "Stopped (tilt)", "Stopped (slide)");
inline constexpr auto flap_commands = command_values<2>("Close", "Open");
inline constexpr auto top_commands = three_commands("Close", "Open", "Stop");
inline constexpr auto sliding_roof_commands =
    command_values<3>("Close (tilt)", "Close (slide)", "Open (tilt)", "Open (slide)", "Stop");

/// Fields of the flaps; `top` has the codes of convertible top and back door, which can be stopped.
constexpr auto flaps(unsigned bits, Items<NamedValue> flap, Items<NamedValue> top) {
  return side_by_side(
      field(bits, "eh", "engine hood", flap), field(bits, "fd", "fuel door", flap),
      field(bits, "bl", "boot lid", flap), field(bits, "ct", "convertible top", top),
      field(bits, "bd", "back door", top), field(bits, "blw", "boot lid window", flap));
}
inline constexpr auto car_flap_status_fields =
    side_by_side(flaps(3, flap_states, top_states),
                 field(4, "sr", "sliding roof", sliding_roof_states), reserved<2>());
inline constexpr auto car_flap_status_object =
    variable_object(0x6010, "Car flap status", "4.2.2.10", "Which flaps and roofs are open.",
                    status(DataType::unsigned24, Mapping::by_default, car_flap_status_fields),
                    {.errata = "C2, C3, C8, C12"});
inline constexpr auto car_flap_command_fields =
    side_by_side(flaps(2, flap_commands, top_commands),
                 field(3, "sr", "sliding roof", sliding_roof_commands), reserved<1>());
inline constexpr auto car_flap_command_object = variable_object(
    0x6011, "Car flap command", "4.2.2.11", "Opens and closes flaps and roofs.",
    command(DataType::unsigned16, car_flap_command_fields), {.errata = "A8, C2, C3, C8, C12"});

// 4.2.2.12 and 4.2.2.13: seats. A seat at rest has no code but "Signal not available" (errata C1).

inline constexpr auto seat_commands = command_values<2>("Seat forward", "Seat backward");
inline constexpr auto seat_height_commands = command_values<2>("Seat up", "Seat down");
inline constexpr auto seat_angle_commands = command_values<2>("Seat angle lift", "Seat angle sink");
inline constexpr auto tight_support_commands =
    command_values<2>("Seat tight support forward", "Seat tight support backward");
inline constexpr auto seat_back_commands =
    command_values<2>("Seat back forward", "Seat back backward");
inline constexpr auto headrest_commands = command_values<2>("Headrest up", "Headrest down");
inline constexpr auto recall_commands = command_values<3>(
    "Recall no memory", "Recall Memory 1", "Recall Memory 2", "Recall Memory 3", "Recall Memory 4");
inline constexpr auto store_commands = command_values<3>(
    "Store no memory", "Store Memory 1", "Store Memory 2", "Store Memory 3", "Store Memory 4");
inline constexpr auto seat_adjustment_command_fields =
    side_by_side(field(2, "sfb", "seat forward/backward", seat_commands),
                 field(2, "sud", "seat up/down", seat_height_commands),
                 field(2, "sals", "seat angle lift/sink", seat_angle_commands),
                 field(2, "stsfb", "seat tight support forward/backward", tight_support_commands),
                 field(2, "sbfb", "seat back forward/backward", seat_back_commands),
                 field(2, "hud", "headrest up/down", headrest_commands),
                 field(3, "rm", "recall memory", recall_commands),
                 field(3, "sm", "store memory", store_commands), reserved<2, 3>());
inline constexpr EntryInfo seat_adjustment_command_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Seat adjustment command driver",
       command(DataType::unsigned24, seat_adjustment_command_fields)),
    at(2, "Seat adjustment command front passenger",
       command(DataType::unsigned24, seat_adjustment_command_fields))};
inline constexpr auto seat_adjustment_command_object =
    array_object(0x6018, "Seat adjustment command", "4.2.2.12",
                 "Moves the front seats, stores and recalls their positions.",
                 seat_adjustment_command_entries, optional_object);

inline constexpr auto seat_states =
    status_values<2>("Seat is moving forward", "Seat is moving backward");
inline constexpr auto seat_height_states =
    status_values<2>("Seat is moving up", "Seat is moving down");
inline constexpr auto seat_angle_states = status_values<2>("Seat angle lift", "Seat angle sink");
inline constexpr auto tight_support_states =
    status_values<2>("Seat tight support forward", "Seat tight support backward");
inline constexpr auto seat_back_states =
    status_values<2>("Seat back is moving forward", "Seat back is moving backward");
inline constexpr auto headrest_states =
    status_values<2>("Headrest is moving up", "Headrest is moving down");
/// States of five values, with two codes for "Failure": a sender uses 06h (errata A9).
constexpr std::array<NamedValue, 8> memory_states(const std::string_view (&states)[5]) {
  return {NamedValue{0, states[0]},
          NamedValue{1, states[1]},
          NamedValue{2, states[2]},
          NamedValue{3, states[3]},
          NamedValue{4, states[4]},
          status_sentinels<3>.second_highest,
          NamedValue{5, "Failure", Meaning::failure},
          status_sentinels<3>.highest};
}
inline constexpr auto recall_states =
    memory_states({"No memory recalled", "Memory 1 recalled", "Memory 2 recalled",
                   "Memory 3 recalled", "Memory 4 recalled"});
inline constexpr auto store_states =
    memory_states({"No memory stored", "Memory 1 stored", "Memory 2 stored", "Memory 3 stored",
                   "Memory 4 stored"});
inline constexpr auto seat_adjustment_status_fields =
    side_by_side(field(2, "sfb", "seat forward/backward", seat_states),
                 field(2, "sud", "seat up/down", seat_height_states),
                 field(2, "sals", "seat angle lift/sink", seat_angle_states),
                 field(2, "stsfb", "seat tight support forward/backward", tight_support_states),
                 field(2, "sbfb", "seat back forward/backward", seat_back_states),
                 field(2, "hud", "headrest up/down", headrest_states),
                 field(3, "rm", "recall memory", recall_states),
                 field(3, "sm", "store memory", store_states), reserved<2, 3>());
inline constexpr EntryInfo seat_adjustment_status_entries[] = {
    highest_sub_index(2, 2),
    at(1, "Seat adjustment status driver",
       status(DataType::unsigned24, Mapping::by_default, seat_adjustment_status_fields)),
    at(2, "Seat adjustment status front passenger",
       status(DataType::unsigned24, Mapping::by_default, seat_adjustment_status_fields))};
inline constexpr auto seat_adjustment_status_object = array_object(
    0x6019, "Seat adjustment status", "4.2.2.13", "Whether and how the front seats move.",
    seat_adjustment_status_entries, {.category = Category::optional, .errata = "A9, A16, C1"});

// 4.2.2.14 and 4.2.2.15: wipers.

inline constexpr auto front_wiper_states =
    status_values<3>("Front wiper system is off", "Tip wiping is on");
inline constexpr auto front_washer_states =
    status_values<3>("Front washer system is off", "Washing is on");
inline constexpr auto wiper_switch_states =
    status_values<3>("Wiper switch stage 0 (off)", "Wiper switch stage I (interval)",
                     "Wiper switch stage II (stage 1)", "Wiper switch stage III (stage 2)",
                     "Wiper switch automatic");
inline constexpr auto rear_wiper_states =
    status_values<3>("Rear wiper system is off", "Rear wiper system is on");
inline constexpr auto rear_washer_states =
    status_values<3>("Rear washer system is off", "Washing is on");
inline constexpr auto wiper_system_status_fields =
    side_by_side(field(3, "wsf", "wiper system front", front_wiper_states),
                 field(3, "wwf", "wiper washer front", front_washer_states),
                 field(3, "wspf", "wiper switch position front", wiper_switch_states),
                 field(3, "wsr", "wiper system rear", rear_wiper_states),
                 field(3, "wwr", "wiper washer rear", rear_washer_states), reserved<1>());
inline constexpr auto wiper_system_status_object =
    variable_object(0x601A, "Wiper system status", "4.2.2.14", "What wipers and washers do.",
                    status(DataType::unsigned16, Mapping::by_default, wiper_system_status_fields));

inline constexpr auto front_wiper_commands =
    command_values<2>("Switch the front wiper system off", "Switch tip wiping on");
inline constexpr auto front_washer_commands =
    command_values<2>("Switch the front washing off", "Switch the front washing on");
inline constexpr auto wiper_switch_commands =
    command_values<3>("Stage 0 (off)", "Stage I (interval)", "Stage II (stage 1)",
                      "Stage III (stage 2)", "Automatic");
inline constexpr auto rear_wiper_commands =
    command_values<2>("Switch the rear wiper system off", "Switch the rear wiper system on");
inline constexpr auto rear_washer_commands =
    command_values<2>("Switch the rear washer system off", "Switch the rear washer system on");
inline constexpr auto wiper_system_command_fields =
    side_by_side(field(2, "wsf", "wiper system front", front_wiper_commands),
                 field(2, "wwf", "wiper washer front", front_washer_commands),
                 field(3, "wspf", "wiper switch position front", wiper_switch_commands),
                 field(2, "wsr", "wiper system rear", rear_wiper_commands),
                 field(2, "wwr", "wiper washer rear", rear_washer_commands), reserved<1, 5>());
inline constexpr auto wiper_system_command_object = variable_object(
    0x601B, "Wiper system command", "4.2.2.15", "Sets wipers and washers going.",
    command(DataType::unsigned16, wiper_system_command_fields), {.errata = "A5, A11, D1, D6"});

// 4.2.2.16 to 4.2.2.19: steering wheel, turn indicator, temperatures.

inline constexpr NamedValue steering_wheel_signs[] = {{0, "Steering wheel angle positive/left"},
                                                      {1, "Steering wheel angle negative/right"},
                                                      status_sentinels<2>.second_highest,
                                                      status_sentinels<2>.highest};
inline constexpr auto steering_wheel_angle_fields =
    side_by_side(field(14, "steering wheel angle", "how far the wheel is turned",
                       measured<14, 0x3800>(Unit::degree, {.denominator = 10})),
                 field(2, "swas", "steering wheel angle sign", steering_wheel_signs));
inline constexpr auto steering_wheel_angle_object =
    variable_object(0x601C, "Steering wheel angle", "4.2.2.16", "Where the steering wheel stands.",
                    status(DataType::unsigned16, Mapping::no, steering_wheel_angle_fields),
                    {.errata = "A1, B6, D12"});

inline constexpr auto turn_indicator_resets =
    status_values<2>("No turn indicator reset detected", "Turn indicator reset detected");
inline constexpr auto turn_indicator_reset_status_fields =
    side_by_side(field(2, "right turn indicator reset", "", turn_indicator_resets),
                 field(2, "left turn indicator reset", "", turn_indicator_resets), reserved<4>());
inline constexpr auto turn_indicator_reset_status_object = variable_object(
    0x601D, "Turn indicator reset status", "4.2.2.17",
    "Whether the steering wheel has put a turn indicator back.",
    status(DataType::unsigned8, Mapping::by_default, turn_indicator_reset_status_fields));

/// Raw values start at -50 degrees.
inline constexpr Scale half_degrees = {.denominator = 2, .offset = -100};
inline constexpr auto displayed_outside_air_temperature_object = variable_object(
    0x6020, "Displayed outside air temperature", "4.2.2.18",
    "Temperature outside, as the driver sees it.",
    status(DataType::unsigned8, Mapping::no, measured<8>(Unit::degree_celsius, half_degrees)),
    optional_object);
inline constexpr auto displayed_inside_air_temperature_object = variable_object(
    0x6021, "Displayed inside air temperature", "4.2.2.19",
    "Temperature inside, as the driver sees it.",
    status(DataType::unsigned8, Mapping::no, measured<8>(Unit::degree_celsius, half_degrees)),
    optional_object);

// 4.2.2.20 and 4.2.2.21: climate.

inline constexpr auto function_commands =
    command_values<2>("Deactivate the function", "Activate the function");
inline constexpr auto defrost_commands =
    command_values<2>("Deactivate the function", "Defrost front window (fans on with full power)");
inline constexpr auto temperature_commands =
    three_commands("Deactivate the function", "+ (0,5 °C)", "- (0,5 °C)");
inline constexpr auto recirculation_commands =
    command_values<2>("Recirculation air off", "Recirculation air on");
inline constexpr auto function_states =
    status_values<2>("Function is not active", "Function is active");

/// Fields of heating and air conditioner.
constexpr auto climate(Items<NamedValue> heat, Items<NamedValue> defrost,
                       Items<NamedValue> temperature, Items<NamedValue> recirculation) {
  return side_by_side(field(2, "hfw", "heat front window", heat),
                      field(2, "hrw", "heat rear window", heat),
                      field(2, "acc", "automatic conditioner control", heat),
                      field(2, "dfw", "defrost front window", defrost),
                      field(2, "temp", "temperature control", temperature),
                      field(2, "recair", "recirculation air", recirculation), reserved<2, 2>());
}
inline constexpr auto heating_and_air_conditioner_command_fields =
    climate(function_commands, defrost_commands, temperature_commands, recirculation_commands);
inline constexpr auto heating_and_air_conditioner_command_object =
    variable_object(0x6025, "Heating and air conditioner command", "4.2.2.20",
                    "Switches heating and air conditioner.",
                    command(DataType::unsigned16, heating_and_air_conditioner_command_fields),
                    {.category = Category::optional, .errata = "A8, A16, C12, D5"});
inline constexpr auto heating_and_air_conditioner_status_fields =
    climate(function_states, function_states, function_states, function_states);
inline constexpr auto heating_and_air_conditioner_status_object = variable_object(
    0x6026, "Heating and air conditioner status", "4.2.2.21",
    "What heating and air conditioner do.",
    status(DataType::unsigned16, Mapping::no, heating_and_air_conditioner_status_fields),
    {.category = Category::optional, .errata = "A16, C12, D8"});

// 4.2.2.22 and 4.2.2.23: occupants and their belts.

inline constexpr auto seat_occupation = status_values<2>("Free", "Occupied");
inline constexpr auto occupant_classification_status_fields = side_by_side(
    field(2, "docs", "driver occupant classification status", seat_occupation),
    field(2, "fpocs", "front passenger occupant classification status", seat_occupation),
    field(2, "rrpocs", "rear right passenger occupant classification status", seat_occupation),
    field(2, "rlpocs", "rear left passenger occupant classification status", seat_occupation),
    field(2, "rmpocs", "rear middle passenger occupant classification status", seat_occupation),
    field(2, "3rrocs", "3rd row right passenger occupant classification status", seat_occupation),
    field(2, "3rlocs", "3rd row left passenger occupant classification status", seat_occupation),
    field(2, "3rmocs", "3rd row middle passenger occupant classification status", seat_occupation));
inline constexpr auto occupant_classification_status_object = variable_object(
    0x6027, "Occupant classification status", "4.2.2.22", "Which seats are taken.",
    status(DataType::unsigned16, Mapping::by_default, occupant_classification_status_fields));

inline constexpr auto seatbelt_states =
    status_values<2>("Seatbelt not fastened", "Seatbelt fastened");
inline constexpr auto buckle_switch_status_fields =
    side_by_side(field(2, "bsd", "buckle switch driver", seatbelt_states),
                 field(2, "bsfp", "buckle switch front passenger", seatbelt_states),
                 field(2, "bsrr", "buckle switch rear right", seatbelt_states),
                 field(2, "bsrl", "buckle switch rear left", seatbelt_states),
                 field(2, "bsrm", "buckle switch rear middle", seatbelt_states),
                 field(2, "3rr", "3rd row right", seatbelt_states),
                 field(2, "3rl", "3rd row left", seatbelt_states),
                 field(2, "3rm", "3rd row middle", seatbelt_states));
inline constexpr auto buckle_switch_status_object =
    variable_object(0x6028, "Buckle switch status", "4.2.2.23", "Which belts are fastened.",
                    status(DataType::unsigned16, Mapping::by_default, buckle_switch_status_fields));

// 4.2.2.24 to 4.2.2.30.

inline constexpr auto vin_data_object =
    variable_object(0x602B, "VIN data", "4.2.2.24",
                    "Vehicle identification number; 17 bytes of 00h where it is not known.",
                    status_text(17, true), {.errata = "A14"});

// Code 6 is reserved, between others (errata C13).
inline constexpr auto language_commands =
    command_values<5>("German", "English", "French", "Italian", "Spanish", "Japanese", "Reserved",
                      "Dutch", "Danish", "Swedish", "Turkish", "Portuguese", "Russian");
inline constexpr auto language_states =
    status_values<5>("German", "English", "French", "Italian", "Spanish", "Japanese", "Reserved",
                     "Dutch", "Danish", "Swedish", "Turkish", "Portuguese", "Russian");
inline constexpr auto user_selected_language_command_fields = side_by_side(
    field(5, "language", "language of what people read", language_commands), reserved<1, 3>());
inline constexpr auto user_selected_language_command_object = variable_object(
    0x602C, "User-selected language command", "4.2.2.25", "Chooses the language.",
    command(DataType::unsigned8, user_selected_language_command_fields), {.errata = "C13"});
inline constexpr auto user_selected_language_status_fields = side_by_side(
    field(5, "language", "language of what people read", language_states), reserved<1, 3>());
inline constexpr auto user_selected_language_status_object = variable_object(
    0x602D, "User-selected language status", "4.2.2.26", "The language that is chosen.",
    status(DataType::unsigned8, Mapping::no, user_selected_language_status_fields),
    {.errata = "C13"});

inline constexpr auto day_night = status_values<2>("Day", "Night");
inline constexpr auto day_night_detection_fields =
    side_by_side(field(2, "day/night detection", "whether it is dark", day_night), reserved<6>());
inline constexpr auto day_night_detection_object = variable_object(
    0x6030, "Day/night detection", "4.2.2.27", "Whether it is dark.",
    status(DataType::unsigned8, Mapping::by_default, day_night_detection_fields), optional_object);
inline constexpr auto environment_light_intensity_object = variable_object(
    0x6031, "Environment light intensity", "4.2.2.28", "How light it is outside.",
    status(DataType::unsigned8, Mapping::by_default, measured<8, 100>(Unit::percent)),
    optional_object);

inline constexpr auto airbag_states = status_values<2>("Airbag not released", "Airbag released");
inline constexpr auto presafe_states = status_values<2>(
    "Presafe acceleration threshold not exceeded", "Presafe acceleration threshold exceeded");
inline constexpr auto motor_stop_states =
    status_values<2>("No accident motor stop", "Accident motor stop");
inline constexpr auto accident_states = status_values<2>("No accident", "Accident");
inline constexpr auto accident_detection_fields =
    side_by_side(field(2, "airrel", "airbag released", airbag_states),
                 field(2, "pate", "presafe acceleration threshold exceeded", presafe_states),
                 field(2, "ams", "accident motor stop", motor_stop_states),
                 field(2, "accident", "accident", accident_states), reserved<2, 4>());
inline constexpr auto accident_detection_object = variable_object(
    0x6032, "Accident detection", "4.2.2.29", "Whether the car has had an accident.",
    status(DataType::unsigned16, Mapping::by_default, accident_detection_fields),
    {.errata = "A15"});

inline constexpr auto diagnose_sessions = status_values<2>("The UDS diagnose session is not active",
                                                           "The UDS diagnose session is active");
inline constexpr auto tester_present_fields =
    side_by_side(field(2, "UDS diagnose session", "", diagnose_sessions), reserved<6>());
inline constexpr auto tester_present_object = variable_object(
    0x6033, "Tester present", "4.2.2.30",
    "Whether a UDS tester (ISO 15765-3, ISO 14229-1) is at work.",
    status(DataType::unsigned8, Mapping::by_default, tester_present_fields), optional_object);

}  // namespace canvoy::cia447
