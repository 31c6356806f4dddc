// Meanings of the values of CiA 402 drives: control word and status word, modes, option codes.
// Profiles that have them at other indices share them.
//
//     cia402::drive_state(0x0637)  // DriveState::operation_enabled
#pragma once

#include <cstdint>

#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia402 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Quick stop is requested or active while the bit is 0.
inline constexpr NamedValue quick_stop_names[] = {{0, "quick stop"}, {1, "no quick stop"}};
inline constexpr NamedValue manufacturer_1[] = {
    {0, 1, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr NamedValue manufacturer_2[] = {
    {0, 3, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr NamedValue manufacturer_5[] = {
    {0, 0x1F, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr NamedValue reserved_1[] = {{0, "0", Meaning::padding},
                                            {1, "reserved", Meaning::reserved}};

/// 6040h. Bits 4 to 6 and 9 depend on the mode of operation (6061h).
inline constexpr FieldInfo controlword_fields[] = {
    field(0, 1, "Switch on"),
    field(1, 1, "Enable voltage"),
    field(2, 1, "Quick stop", quick_stop_names),
    field(3, 1, "Enable operation"),
    field(4, 1, "New set-point", "Profile position mode; in homing mode it starts the homing."),
    field(5, 1, "Change set immediately", "Profile position mode."),
    field(6, 1, "Relative", "Profile position mode: from the last target on."),
    field(7, 1, "Fault reset", "By its edge from 0 to 1."),
    field(8, 1, "Halt"),
    field(9, 1, "Operation mode specific"),
    field(10, 1, "reserved", reserved_1),
    field(11, 5, "Manufacturer-specific", manufacturer_5),
};

/// 6041h. Bits 12 and 13 depend on the mode of operation (6061h).
inline constexpr FieldInfo statusword_fields[] = {
    field(0, 1, "Ready to switch on"),
    field(1, 1, "Switched on"),
    field(2, 1, "Operation enabled"),
    field(3, 1, "Fault"),
    field(4, 1, "Voltage enabled"),
    field(5, 1, "Quick stop", quick_stop_names),
    field(6, 1, "Switch on disabled"),
    field(7, 1, "Warning"),
    field(8, 1, "Manufacturer-specific", manufacturer_1),
    field(9, 1, "Remote"),
    field(10, 1, "Target reached"),
    field(11, 1, "Internal limit active"),
    field(12, 1, "Set-point acknowledge, speed 0 or homing attained",
          "Profile position, profile velocity, homing mode."),
    field(13, 1, "Following error, max slippage or homing error",
          "Profile position, profile velocity, homing mode."),
    field(14, 2, "Manufacturer-specific bits", manufacturer_2),
};

/// Commands of the controlword: bits 0 to 3 and 7.
enum class DriveCommand : std::uint8_t {
  disable_voltage = 0x00,
  quick_stop = 0x02,
  shutdown = 0x06,
  switch_on = 0x07,  ///< and disable operation
  enable_operation = 0x0F,
  fault_reset = 0x80,  ///< by the edge of bit 7
};

/// States of the drive, as bits 0 to 3, 5 and 6 of the statusword report them.
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
/// State of a statusword, by its bits 0 to 3, 5 and 6.
constexpr DriveState drive_state(std::uint16_t statusword) {
  // With switch-on disabled or the drive in fault, bit 5 does not matter.
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

/// 6060h and 6061h.
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

/// 6502h. The bit of a mode is its number minus 1.
inline constexpr FieldInfo supported_mode_fields[] = {
    field(0, 1, "profile position mode"),
    field(1, 1, "velocity mode"),
    field(2, 1, "profile velocity mode"),
    field(3, 1, "torque mode"),
    field(5, 1, "homing mode"),
    field(6, 1, "interpolated position mode"),
    field(7, 1, "cyclic synchronous position mode"),
    field(8, 1, "cyclic synchronous velocity mode"),
    field(9, 1, "cyclic synchronous torque mode"),
};

// Option codes: reactions of the drive when it leaves a state.

/// Reaction that an option code selects (605Ah to 605Eh).
enum class StopReaction : std::int16_t {
  disable = 0,
  slow_down_ramp = 1,
  quick_stop_ramp = 2,
  current_limit = 3,
  voltage_limit = 4,
  slow_down_ramp_and_stay = 5,  ///< in quick stop
  quick_stop_ramp_and_stay = 6,
  current_limit_and_stay = 7,
  voltage_limit_and_stay = 8,
};
inline constexpr NamedValue manufacturer_option = {-32768, -1, "manufacturer-specific",
                                                   Meaning::manufacturer};
inline constexpr NamedValue abort_connection_option_names[] = {
    manufacturer_option,    {0, "no action"},  {1, "malfunction"},
    {2, "disable voltage"}, {3, "quick stop"}, {4, 32767, "reserved", Meaning::reserved}};
inline constexpr NamedValue quick_stop_option_names[] = {
    manufacturer_option,
    {StopReaction::disable, "disable the drive function"},
    {StopReaction::slow_down_ramp, "slow down on the slow-down ramp"},
    {StopReaction::quick_stop_ramp, "slow down on the quick-stop ramp"},
    {StopReaction::current_limit, "slow down on the current limit"},
    {StopReaction::voltage_limit, "slow down on the voltage limit"},
    {StopReaction::slow_down_ramp_and_stay, "slow-down ramp, then stay in quick stop"},
    {StopReaction::quick_stop_ramp_and_stay, "quick-stop ramp, then stay in quick stop"},
    {StopReaction::current_limit_and_stay, "current limit, then stay in quick stop"},
    {StopReaction::voltage_limit_and_stay, "voltage limit, then stay in quick stop"},
    {9, 32767, "reserved", Meaning::reserved}};
/// 605Bh and 605Ch.
inline constexpr NamedValue shutdown_option_names[] = {
    manufacturer_option,
    {StopReaction::disable, "disable the drive function"},
    {StopReaction::slow_down_ramp, "slow down on the slow-down ramp"},
    {2, 32767, "reserved", Meaning::reserved}};
/// 605Dh and 605Eh; later versions reserve 0 of 605Dh.
inline constexpr NamedValue halt_option_names[] = {
    manufacturer_option,
    {StopReaction::disable, "disable the drive function"},
    {StopReaction::slow_down_ramp, "slow down on the slow-down ramp"},
    {StopReaction::quick_stop_ramp, "slow down on the quick-stop ramp"},
    {StopReaction::current_limit, "slow down on the current limit"},
    {StopReaction::voltage_limit, "slow down on the voltage limit"},
    {5, 32767, "reserved", Meaning::reserved}};

/// 6086h.
enum class ProfileType : std::int16_t {
  linear = 0,
  sine_squared = 1,
  jerk_free = 2,
  jerk_limited = 3,
};
inline constexpr NamedValue profile_type_names[] = {
    manufacturer_option,
    {ProfileType::linear, "linear ramp"},
    {ProfileType::sine_squared, "sin² ramp"},
    {ProfileType::jerk_free, "jerk-free ramp"},
    {ProfileType::jerk_limited, "jerk-limited ramp"},
    {4, 32767, "reserved", Meaning::reserved}};

/// 606Ah.
enum class SensorSelection : std::int16_t { position_encoder = 0, velocity_encoder = 1 };
inline constexpr NamedValue sensor_selection_names[] = {
    manufacturer_option,
    {SensorSelection::position_encoder, "position encoder"},
    {SensorSelection::velocity_encoder, "velocity encoder"},
    {2, 32767, "reserved", Meaning::reserved}};

/// 607Eh.
inline constexpr NamedValue reversal_names[] = {{0, "as it is"}, {1, "reversed"}};
inline constexpr NamedValue reserved_6[] = {{0, "0", Meaning::padding},
                                            {1, 0x3F, "reserved", Meaning::reserved}};
inline constexpr FieldInfo polarity_fields[] = {
    field(0, 6, "reserved", reserved_6),
    field(6, 1, "Velocity polarity", reversal_names),
    field(7, 1, "Position polarity", reversal_names),
};

}  // namespace canvoy::cia402
