// The drive of the car: state machine, modes, limits, motor (CiA 417-4, 4.11.1 and 4.11.2). The
// values are those of CiA 402, at other indices; positions, velocities and accelerations are in the
// units that factors.hpp gives the drive.
//
//     drive[cia417::modes_of_operation] = cia417::DriveMode::profile_velocity;
#pragma once

#include "canvoy/profiles/cia402/values.hpp"
#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

using cia402::drive_state;
using cia402::DriveMode;
using cia402::DriveState;
using cia402::ProfileType;
using cia402::SensorSelection;
using cia402::StopReaction;

/// A variable that the car drive controller and the car drive unit have.
constexpr EntryInfo drive_entry(DataType type, const ValueInfo& value = {},
                                Items<FieldInfo> fields = {}) {
  return provided(entry(type, ro, optional, {}, value, fields));
}
/// A setting of the car drive unit.
constexpr EntryInfo drive_setting(DataType type, const ValueInfo& value = {}) {
  return entry(type, rw, no, {}, value);
}
/// A position, velocity, acceleration or jerk in the units of 6410h to 6413h, or another number
/// without a defined unit.
inline constexpr ValueInfo drive_amount = {.counting = Counting::counts};
/// The entry with another name.
constexpr EntryInfo named(std::string_view name, EntryInfo entry) {
  entry.name = name;
  return entry;
}
/// The entry with another default.
constexpr EntryInfo with_default(EntryInfo entry, Default initial) {
  entry.initial = initial;
  return entry;
}

// 6400h and 6401h: CiA 402, 6040h and 6041h.

inline constexpr auto controlword_object = var_object(
    0x6400, "Controlword", "4.11.1.1", "As 6040h of CiA 402: moves the state machine of the drive.",
    drive_entry(DataType::unsigned16, hexadecimal, cia402::controlword_fields),
    {.condition = see_part_2, .errata = "C14"});

/// Bits 12 and 13 as defined for lifts (4.11).
inline constexpr auto statusword_fields = [] {
  auto fields = std::to_array(cia402::statusword_fields);
  for (FieldInfo& bit : fields) {
    if (bit.first_bit == 12) {
      bit.name = "Set-point acknowledge or speed 0";
      bit.description =
          "Profile position mode: the new target can be reached. Profile velocity mode: speed 0. "
          "Homing mode: homing attained.";
    } else if (bit.first_bit == 13) {
      bit.name = "Following error or max slippage";
      bit.description =
          "Profile position mode: following error. Profile velocity mode: max slippage. Homing "
          "mode: homing error.";
    }
  }
  return fields;
}();
inline constexpr auto statusword_object =
    var_object(0x6401, "Statusword", "4.11.1.2",
               "As 6041h of CiA 402: the state of the drive, and whether it has arrived.",
               drive_entry(DataType::unsigned16, hexadecimal, statusword_fields),
               {.condition = see_part_2, .errata = "B20, C14"});

// 6402h: reactions of the drive when it leaves a state.

/// A reaction of the drive, as in CiA 402.
constexpr EntryInfo option_code(std::uint8_t sub, std::string_view name, Default initial,
                                Items<NamedValue> names) {
  return optional_at(
      sub, sub,
      with_default(named(name, drive_setting(DataType::integer16, {.names = names})), initial));
}
inline constexpr EntryInfo control_option_codes_entries[] = {
    number_of_entries(0x01, 0x05),
    option_code(1, "Shutdown option code", 0, cia402::shutdown_option_names),
    option_code(2, "Disable operation option code", 1, cia402::shutdown_option_names),
    option_code(3, "Quick stop option code", 2, cia402::quick_stop_option_names),
    option_code(4, "Halt option code", 1, cia402::halt_option_names),
    option_code(5, "Fault reaction option code", 2, cia402::halt_option_names)};
inline constexpr auto control_option_codes_object =
    array_object(0x6402, "Control option codes", "4.11.1.3",
                 "As 605Bh, 605Ch, 605Ah, 605Dh and 605Eh of CiA 402, in this order.",
                 control_option_codes_entries, {.category = Category::optional});

// 6403h to 6406h

inline constexpr auto modes_of_operation_object =
    var_object(0x6403, "Modes of operation", "4.11.1.4",
               "As 6060h of CiA 402: lifts use profile position and profile velocity mode.",
               drive_entry(DataType::integer8, {.names = cia402::drive_mode_names}),
               {.condition = see_part_2, .errata = "C14"});
inline constexpr auto modes_of_operation_display_object =
    var_object(0x6404, "Modes of operation display", "4.11.1.5",
               "As 6061h of CiA 402: the mode that the drive is in.",
               drive_entry(DataType::integer8, {.names = cia402::drive_mode_names}),
               {.condition = see_part_2, .errata = "C14"});

inline constexpr auto motion_profile_type_object = var_object(
    0x6405, "Motion profile type", "4.11.1.6", "As 6086h of CiA 402: the shape of the ramps.",
    entry(integer16, rw, optional, {}, cia402::profile_type_names),
    {.condition = see_part_2, .errata = "C14"});
inline constexpr auto control_effort_object =
    var_object(0x6406, "Control effort", "4.11.1.7",
               "As 60FAh of CiA 402: what the control loop gives to the drive.",
               drive_entry(DataType::integer32, drive_amount),
               {.condition = see_part_2, .errata = "C12, C14, C17"});

// 6408h to 640Dh Limits and ramps.

inline constexpr EntryInfo max_velocity_entries[] = {
    number_of_entries(0x01, 0x02),
    optional_at(1, 1,
                named("Max profile velocity", drive_setting(DataType::unsigned32, drive_amount))),
    // Errata B6.
    optional_at(2, 2,
                sub_index(0, "Max motor speed",
                          entry(unsigned32, ro, no, {}, {.unit = Unit::revolution_per_minute})))};
inline constexpr auto max_velocity_object =
    array_object(0x6408, "Max velocity and speed", "4.11.1.8", "As 607Fh and 6080h of CiA 402.",
                 max_velocity_entries, {.category = Category::optional, .errata = "B6"});

inline constexpr EntryInfo max_acceleration_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, named("Max acceleration", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 2,
                named("Max deceleration", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr auto max_acceleration_object =
    array_object(0x6409, "Max acceleration and deceleration", "4.11.1.9",
                 "As 60C5h and 60C6h of CiA 402; without sub-index 02h, 01h is for both.",
                 max_acceleration_entries, {.category = Category::optional});

inline constexpr auto quick_stop_deceleration_object =
    var_object(0x640A, "Quick stop deceleration", "4.11.1.10", "As 6085h of CiA 402.",
               entry(unsigned32, rw, optional, {}, drive_amount),
               {.category = Category::optional, .errata = "A2, C14"});

inline constexpr EntryInfo profile_acceleration_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, named("Profile acceleration", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 2,
                named("Profile deceleration", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr auto profile_acceleration_object =
    array_object(0x640B, "Profile acceleration and deceleration", "4.11.1.11",
                 "As 6083h and 6084h of CiA 402; without sub-index 02h, 01h is for both.",
                 profile_acceleration_entries, {.category = Category::optional});

// Number of jerks of 640Dh in use, and the bends of the velocity to which they apply, A to F of
// figure 1.
inline constexpr NamedValue jerk_use_names[] = {
    {0x00, "no jerk"},
    {0x01, "jerk 1 for A to D"},
    {0x02, "jerk 1 for A and B, 2 for C and D"},
    {0x03, "reserved", Meaning::reserved},
    {0x04, "jerk 1 for A, 3 for B, 2 for C, 4 for D"},
    {0x05, "reserved", Meaning::reserved},
    {0x06, "jerk 1 for A, 3 for B, 2 for C, 4 for D, 5 for E, 6 for F"}};
inline constexpr auto profile_jerk_use_object = var_object(
    0x640C, "Profile jerk use", "4.11.1.12",
    "How many jerks of 640Dh are used; without this object, all that it has.",
    drive_setting(DataType::unsigned8, {.limits = within(0x00, 0x06), .names = jerk_use_names}),
    {.category = Category::optional, .errata = "A16"});

inline constexpr NamedValue jerk_count_names[] = {{0x03, "reserved", Meaning::reserved},
                                                  {0x05, "reserved", Meaning::reserved}};
inline constexpr EntryInfo profile_jerk_entries[] = {
    sub_index(0, "Number of entries",
              entry(unsigned8, ro, no, highest_sub(),
                    {.limits = within(0x01, 0x06), .names = jerk_count_names})),
    at(1, named("Profile jerk #", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 6, named("Profile jerk #", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr auto profile_jerk_object =
    array_object(0x640D, "Profile jerk", "4.11.1.13",
                 "Jerks of the bends of the velocity: 1, 2, 4 or 6 of them.", profile_jerk_entries,
                 {.category = Category::optional, .errata = "A16, B8"});

// 640Fh: the maker of the drive defines the contents; no layout is given here.
inline constexpr EntryInfo motor_datum =
    sub_index(0, "manufacturer-specific", entry(domain, rw),
              {.description = "The type is the maker's, too."});
inline constexpr EntryInfo motor_data_entries[] = {
    count_entry("Number of entries", 0x01, last_of_many), at(1, motor_datum),
    optional_at(2, last_of_many, motor_datum)};
inline constexpr auto motor_data_object = record_object(
    0x640F, "Motor data", "4.11.2", "All that is known of the motor, as its maker says.",
    motor_data_entries, {.category = Category::optional, .errata = "C18"});

}  // namespace canvoy::cia417
