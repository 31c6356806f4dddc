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
  return provided({.type = type, .mapping = Mapping::optional, .value = value, .fields = fields});
}
/// A setting of the car drive unit.
constexpr EntryInfo drive_setting(DataType type, const ValueInfo& value = {}) {
  return {.type = type, .access = Access::rw, .value = value};
}
/// A position, velocity, acceleration or jerk in the units of 6410h to 6413h, or another number
/// that no unit is given for.
inline constexpr ValueInfo drive_amount = {.counting = Counting::counts};
constexpr EntryInfo named(std::string_view name, EntryInfo entry) {
  entry.name = name;
  return entry;
}
constexpr EntryInfo with_default(EntryInfo entry, Default initial) {
  entry.initial = initial;
  return entry;
}

// 6400h and 6401h: CiA 402, 6040h and 6041h.

inline constexpr ObjectInfo controlword_object = {
    .index = 0x6400,
    .name = "Controlword",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.1",
    .errata = "C14",
    .description = "As 6040h of CiA 402: moves the state machine of the drive.",
    .entry = drive_entry(DataType::unsigned16, hexadecimal, cia402::controlword_fields)};

/// Bits 12 and 13 as lifts have them (4.11).
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
inline constexpr ObjectInfo statusword_object = {
    .index = 0x6401,
    .name = "Statusword",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.2",
    .errata = "B20, C14",
    .description = "As 6041h of CiA 402: the state of the drive, and whether it has arrived.",
    .entry = drive_entry(DataType::unsigned16, hexadecimal, statusword_fields)};

// 6402h: what the drive does when it leaves a state.

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
inline constexpr ObjectInfo control_option_codes_object = {
    .index = 0x6402,
    .code = ObjectCode::array,
    .name = "Control option codes",
    .category = Category::optional,
    .clause = "4.11.1.3",
    .description = "As 605Bh, 605Ch, 605Ah, 605Dh and 605Eh of CiA 402, in this order.",
    .subs = control_option_codes_entries};

// 6403h to 6406h

inline constexpr ObjectInfo modes_of_operation_object = {
    .index = 0x6403,
    .name = "Modes of operation",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.4",
    .errata = "C14",
    .description = "As 6060h of CiA 402: lifts use profile position and profile velocity mode.",
    .entry = drive_entry(DataType::integer8, {.names = cia402::drive_mode_names})};
inline constexpr ObjectInfo modes_of_operation_display_object = {
    .index = 0x6404,
    .name = "Modes of operation display",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.5",
    .errata = "C14",
    .description = "As 6061h of CiA 402: the mode that the drive is in.",
    .entry = drive_entry(DataType::integer8, {.names = cia402::drive_mode_names})};

inline constexpr ObjectInfo motion_profile_type_object = {
    .index = 0x6405,
    .name = "Motion profile type",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.6",
    .errata = "C14",
    .description = "As 6086h of CiA 402: the shape of the ramps.",
    .entry = {.type = DataType::integer16,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .value = {.names = cia402::profile_type_names}}};
inline constexpr ObjectInfo control_effort_object = {
    .index = 0x6406,
    .name = "Control effort",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.7",
    .errata = "C12, C14, C17",
    .description = "As 60FAh of CiA 402: what the control loop gives to the drive.",
    .entry = drive_entry(DataType::integer32, drive_amount)};

// 6408h to 640Dh Limits and ramps.

inline constexpr EntryInfo max_velocity_entries[] = {
    number_of_entries(0x01, 0x02),
    optional_at(1, 1,
                named("Max profile velocity", drive_setting(DataType::unsigned32, drive_amount))),
    // Errata B6.
    optional_at(2, 2,
                {.name = "Max motor speed",
                 .type = DataType::unsigned32,
                 .value = {.unit = Unit::revolution_per_minute}})};
inline constexpr ObjectInfo max_velocity_object = {.index = 0x6408,
                                                   .code = ObjectCode::array,
                                                   .name = "Max velocity and speed",
                                                   .category = Category::optional,
                                                   .clause = "4.11.1.8",
                                                   .errata = "B6",
                                                   .description = "As 607Fh and 6080h of CiA 402.",
                                                   .subs = max_velocity_entries};

inline constexpr EntryInfo max_acceleration_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, named("Max acceleration", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 2,
                named("Max deceleration", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr ObjectInfo max_acceleration_object = {
    .index = 0x6409,
    .code = ObjectCode::array,
    .name = "Max acceleration and deceleration",
    .category = Category::optional,
    .clause = "4.11.1.9",
    .description = "As 60C5h and 60C6h of CiA 402; without sub-index 02h, 01h is for both.",
    .subs = max_acceleration_entries};

inline constexpr ObjectInfo quick_stop_deceleration_object = {
    .index = 0x640A,
    .name = "Quick stop deceleration",
    .category = Category::optional,
    .clause = "4.11.1.10",
    .errata = "A2, C14",
    .description = "As 6085h of CiA 402.",
    .entry = {.type = DataType::unsigned32,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .value = drive_amount}};

inline constexpr EntryInfo profile_acceleration_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, named("Profile acceleration", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 2,
                named("Profile deceleration", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr ObjectInfo profile_acceleration_object = {
    .index = 0x640B,
    .code = ObjectCode::array,
    .name = "Profile acceleration and deceleration",
    .category = Category::optional,
    .clause = "4.11.1.11",
    .description = "As 6083h and 6084h of CiA 402; without sub-index 02h, 01h is for both.",
    .subs = profile_acceleration_entries};

// How many of the jerks of 640Dh are used, and for which bends of the velocity, A to F of figure 1.
inline constexpr NamedValue jerk_use_names[] = {
    {0x00, "no jerk"},
    {0x01, "jerk 1 for A to D"},
    {0x02, "jerk 1 for A and B, 2 for C and D"},
    {0x03, "reserved", Meaning::reserved},
    {0x04, "jerk 1 for A, 3 for B, 2 for C, 4 for D"},
    {0x05, "reserved", Meaning::reserved},
    {0x06, "jerk 1 for A, 3 for B, 2 for C, 4 for D, 5 for E, 6 for F"}};
inline constexpr ObjectInfo profile_jerk_use_object = {
    .index = 0x640C,
    .name = "Profile jerk use",
    .category = Category::optional,
    .clause = "4.11.1.12",
    .errata = "A16",
    .description = "How many jerks of 640Dh are used; without this object, all that it has.",
    .entry = drive_setting(DataType::unsigned8,
                           {.limits = within(0x00, 0x06), .names = jerk_use_names})};

inline constexpr NamedValue jerk_count_names[] = {{0x03, "reserved", Meaning::reserved},
                                                  {0x05, "reserved", Meaning::reserved}};
inline constexpr EntryInfo profile_jerk_entries[] = {
    {.name = "Number of entries",
     .initial = highest_sub(),
     .value = {.limits = within(0x01, 0x06), .names = jerk_count_names}},
    at(1, named("Profile jerk #", drive_setting(DataType::unsigned32, drive_amount))),
    optional_at(2, 6, named("Profile jerk #", drive_setting(DataType::unsigned32, drive_amount)))};
inline constexpr ObjectInfo profile_jerk_object = {
    .index = 0x640D,
    .code = ObjectCode::array,
    .name = "Profile jerk",
    .category = Category::optional,
    .clause = "4.11.1.13",
    .errata = "A16, B8",
    .description = "Jerks of the bends of the velocity: 1, 2, 4 or 6 of them.",
    .subs = profile_jerk_entries};

// 640Fh: what it is, the maker of the drive says; so nothing is laid out for it.
inline constexpr EntryInfo motor_datum = {.name = "manufacturer-specific",
                                          .type = DataType::domain,
                                          .access = Access::rw,
                                          .description = "The type is the maker's, too."};
inline constexpr EntryInfo motor_data_entries[] = {
    count_entry("Number of entries", 0x01, last_of_many), at(1, motor_datum),
    optional_at(2, last_of_many, motor_datum)};
inline constexpr ObjectInfo motor_data_object = {
    .index = 0x640F,
    .code = ObjectCode::record,
    .name = "Motor data",
    .category = Category::optional,
    .clause = "4.11.2",
    .errata = "C18",
    .description = "All that is known of the motor, as its maker says.",
    .subs = motor_data_entries};

}  // namespace canvoy::cia417
