// The drive of the car: state machine, modes, limits, motor (CiA 417-4, 4.11.1 and 4.11.2). The
// values are those of CiA 402, at other indices; positions, velocities and accelerations are in the
// units that factors.hpp gives the drive.
//
//     drive[cia417::modes_of_operation] = cia417::DriveMode::profile_velocity;
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

/// A variable that the car drive controller and the car drive unit have.
constexpr EntryInfo drive_entry(DataType type, const ValueInfo& value = {},
                                Items<FieldInfo> fields = {}) {
  return provided({.type = type, .mapping = Mapping::optional, .value = value, .fields = fields});
}
/// A setting of the car drive unit.
constexpr EntryInfo drive_setting(DataType type, const ValueInfo& value = {}) {
  return {.type = type, .access = Access::rw, .value = value};
}
constexpr EntryInfo named(std::string_view name, EntryInfo entry) {
  entry.name = name;
  return entry;
}
constexpr EntryInfo with_default(EntryInfo entry, Default initial) {
  entry.initial = initial;
  return entry;
}

// 6400h and 6401h: CiA 402, 6040h and 6041h.

inline constexpr NamedValue quick_stop_names[] = {{0, "quick stop"}, {1, "no quick stop"}};
inline constexpr NamedValue manufacturer_5[] = {
    {0x00, 0x1F, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr NamedValue manufacturer_2[] = {
    {0, 3, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr FieldInfo controlword_fields[] = {
    field(0, 1, "Switch on"),
    field(1, 1, "Enable voltage"),
    field(2, 1, "Quick stop", {.names = quick_stop_names}),
    field(3, 1, "Enable operation"),
    field(4, 1, "New set-point", {}, "In profile position mode; homing: start."),
    field(5, 1, "Change set immediately", {}, "In profile position mode."),
    field(6, 1, "Relative", {}, "In profile position mode."),
    field(7, 1, "Fault reset", {}, "By its edge from 0 to 1."),
    field(8, 1, "Halt"),
    field(9, 1, "Operation mode specific"),
    reserved_bits<1>(10),
    field(11, 5, "Manufacturer-specific", {.names = manufacturer_5})};
inline constexpr ObjectInfo controlword_object = {
    .index = 0x6400,
    .name = "Controlword",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.1",
    .errata = "C14",
    .description = "As 6040h of CiA 402: moves the state machine of the drive.",
    .entry = drive_entry(DataType::unsigned16, hexadecimal, controlword_fields)};

inline constexpr FieldInfo statusword_fields[] = {
    field(0, 1, "Ready to switch on"),
    field(1, 1, "Switched on"),
    field(2, 1, "Operation enabled"),
    field(3, 1, "Fault"),
    field(4, 1, "Voltage enabled"),
    field(5, 1, "Quick stop", {.names = quick_stop_names}),
    field(6, 1, "Switch on disabled"),
    field(7, 1, "Warning"),
    field(8, 1, "Manufacturer-specific"),
    field(9, 1, "Remote"),
    field(10, 1, "Target reached"),
    field(11, 1, "Internal limit active"),
    field(12, 1, "Set-point acknowledge or speed 0", {},
          "Profile position mode: the new target can be reached. Profile velocity mode: speed 0."),
    field(13, 1, "Following error or max slippage", {},
          "Profile position mode: following error. Profile velocity mode: max slippage."),
    field(14, 2, "Manufacturer-specific bits", {.names = manufacturer_2})};
inline constexpr ObjectInfo statusword_object = {
    .index = 0x6401,
    .name = "Statusword",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.2",
    .errata = "B20, C14",
    .description = "As 6041h of CiA 402: the state of the drive, and whether it has arrived.",
    .entry = drive_entry(DataType::unsigned16, hexadecimal, statusword_fields)};

/// The states that bits 0 to 3, 5 and 6 of the statusword stand for (CiA 402).
enum class DriveState : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction_active,
  fault,
};
constexpr DriveState drive_state(std::uint16_t statusword) {
  // Where the switch-on is disabled or the drive is in fault, bit 5 does not matter.
  switch (statusword & 0x4F) {
    case 0x40:
      return DriveState::switch_on_disabled;
    case 0x0F:
      return DriveState::fault_reaction_active;
    case 0x08:
      return DriveState::fault;
    default:
      break;
  }
  switch (statusword & 0x6F) {
    case 0x21:
      return DriveState::ready_to_switch_on;
    case 0x23:
      return DriveState::switched_on;
    case 0x27:
      return DriveState::operation_enabled;
    case 0x07:
      return DriveState::quick_stop_active;
    default:
      return DriveState::not_ready_to_switch_on;
  }
}

// 6402h: what the drive does when it leaves a state.

inline constexpr NamedValue shutdown_option_names[] = {
    {-32768, -1, "manufacturer-specific", Meaning::manufacturer},
    {0, "disable the drive function"},
    {1, "slow down on the slow-down ramp"},
    {2, 32767, "reserved", Meaning::reserved}};
inline constexpr NamedValue quick_stop_option_names[] = {
    {-32768, -1, "manufacturer-specific", Meaning::manufacturer},
    {0, "disable the drive function"},
    {1, "slow down on the slow-down ramp"},
    {2, "slow down on the quick-stop ramp"},
    {3, "slow down on the current limit"},
    {4, "slow down on the voltage limit"},
    {5, "slow-down ramp, then stay in quick stop"},
    {6, "quick-stop ramp, then stay in quick stop"},
    {7, "current limit, then stay in quick stop"},
    {8, "voltage limit, then stay in quick stop"},
    {9, 32767, "reserved", Meaning::reserved}};
inline constexpr NamedValue halt_option_names[] = {
    {-32768, -1, "manufacturer-specific", Meaning::manufacturer},
    {0, "disable the drive function"},
    {1, "slow down on the slow-down ramp"},
    {2, "slow down on the quick-stop ramp"},
    {3, "slow down on the current limit"},
    {4, "slow down on the voltage limit"},
    {5, 32767, "reserved", Meaning::reserved}};

constexpr EntryInfo option_code(std::uint8_t sub, std::string_view name, Default initial,
                                Items<NamedValue> names) {
  return optional_at(
      sub, sub,
      with_default(named(name, drive_setting(DataType::integer16, {.names = names})), initial));
}
inline constexpr EntryInfo control_option_codes_entries[] = {
    number_of_entries(0x01, 0x05),
    option_code(1, "Shutdown option code", 0, shutdown_option_names),
    option_code(2, "Disable operation option code", 1, shutdown_option_names),
    option_code(3, "Quick stop option code", 2, quick_stop_option_names),
    option_code(4, "Halt option code", 1, halt_option_names),
    option_code(5, "Fault reaction option code", 2, halt_option_names)};
inline constexpr ObjectInfo control_option_codes_object = {
    .index = 0x6402,
    .code = ObjectCode::array,
    .name = "Control option codes",
    .category = Category::optional,
    .clause = "4.11.1.3",
    .description = "As 605Bh, 605Ch, 605Ah, 605Dh and 605Eh of CiA 402, in this order.",
    .subs = control_option_codes_entries};

// 6403h to 6406h

enum class DriveMode : std::int8_t {
  profile_position = 1,
  velocity = 2,
  profile_velocity = 3,
  torque = 4,
  homing = 6,
  interpolated_position = 7,
  cyclic_synchronous_position = 8,
  cyclic_synchronous_velocity = 9,
  cyclic_synchronous_torque = 10,
};
inline constexpr NamedValue drive_mode_names[] = {
    {-128, -1, "manufacturer-specific mode", Meaning::manufacturer},
    {DriveMode::profile_position, "profile position mode"},
    {DriveMode::velocity, "velocity mode"},
    {DriveMode::profile_velocity, "profile velocity mode"},
    {DriveMode::torque, "torque mode"},
    {5, "reserved", Meaning::reserved},
    {DriveMode::homing, "homing mode"},
    {DriveMode::interpolated_position, "interpolated position mode"},
    {DriveMode::cyclic_synchronous_position, "cyclic synchronous position mode"},
    {DriveMode::cyclic_synchronous_velocity, "cyclic synchronous velocity mode"},
    {DriveMode::cyclic_synchronous_torque, "cyclic synchronous torque mode"},
    {11, 127, "reserved", Meaning::reserved}};
inline constexpr ObjectInfo modes_of_operation_object = {
    .index = 0x6403,
    .name = "Modes of operation",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.4",
    .errata = "C14",
    .description = "As 6060h of CiA 402: lifts use profile position and profile velocity mode.",
    .entry = drive_entry(DataType::integer8, {.names = drive_mode_names})};
inline constexpr ObjectInfo modes_of_operation_display_object = {
    .index = 0x6404,
    .name = "Modes of operation display",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.5",
    .errata = "C14",
    .description = "As 6061h of CiA 402: the mode that the drive is in.",
    .entry = drive_entry(DataType::integer8, {.names = drive_mode_names})};

enum class ProfileType : std::int16_t {
  linear = 0,
  sine_squared = 1,
  jerk_free = 2,
  jerk_limited = 3
};
inline constexpr NamedValue profile_type_names[] = {
    {-32768, -1, "manufacturer-specific", Meaning::manufacturer},
    {ProfileType::linear, "linear ramp"},
    {ProfileType::sine_squared, "sin² ramp"},
    {ProfileType::jerk_free, "jerk-free ramp"},
    {ProfileType::jerk_limited, "jerk-limited ramp"},
    {4, 32767, "reserved", Meaning::reserved}};
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
              .value = {.names = profile_type_names}}};
inline constexpr ObjectInfo control_effort_object = {
    .index = 0x6406,
    .name = "Control effort",
    .category = Category::conditional,
    .condition = see_part_2,
    .clause = "4.11.1.7",
    .errata = "C12, C14, C17",
    .description = "As 60FAh of CiA 402: what the control loop gives to the drive.",
    .entry = drive_entry(DataType::integer32)};

// 6408h to 640Dh Limits and ramps.

inline constexpr EntryInfo max_velocity_entries[] = {
    number_of_entries(0x01, 0x02),
    optional_at(1, 1, named("Max profile velocity", drive_setting(DataType::unsigned32))),
    // Errata B6.
    optional_at(2, 2, {.name = "Max motor speed", .type = DataType::unsigned32})};
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
    at(1, named("Max acceleration", drive_setting(DataType::unsigned32))),
    optional_at(2, 2, named("Max deceleration", drive_setting(DataType::unsigned32)))};
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
    .entry = {.type = DataType::unsigned32, .access = Access::rw, .mapping = Mapping::optional}};

inline constexpr EntryInfo profile_acceleration_entries[] = {
    number_of_entries(0x01, 0x02),
    at(1, named("Profile acceleration", drive_setting(DataType::unsigned32))),
    optional_at(2, 2, named("Profile deceleration", drive_setting(DataType::unsigned32)))};
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
    at(1, named("Profile jerk #", drive_setting(DataType::unsigned32))),
    optional_at(2, 6, named("Profile jerk #", drive_setting(DataType::unsigned32)))};
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
