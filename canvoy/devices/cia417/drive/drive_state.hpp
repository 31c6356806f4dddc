// The state machine of CiA 402 drives, at 6400h and 6401h in CiA 417-4: the state that a
// controlword requests, and its code in the statusword.
//
//     drive_command(0x0006)  // shutdown
//     next_state(DriveState::switch_on_disabled, DriveCommand::shutdown)  // ready_to_switch_on
//
// A command that is not defined in a state is ignored. While bit 7 is set, only commands that stop
// the drive take effect. Its edge is the fault reset, which drive_command() does not return.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/profiles/cia402/values.hpp"

namespace canvoy::cia417 {

using cia402::DriveCommand;
using cia402::DriveState;

/// Bits of the controlword that request no state.
namespace control_bit {
inline constexpr std::uint16_t new_set_point = 0x0010;  ///< in homing mode: start
/// Without waiting for the present target.
inline constexpr std::uint16_t change_immediately = 0x0020;
inline constexpr std::uint16_t relative = 0x0040;     ///< 6420h is a distance
inline constexpr std::uint16_t fault_reset = 0x0080;  ///< its rising edge resets a fault
inline constexpr std::uint16_t halt = 0x0100;         ///< stops the car on its ramp
}  // namespace control_bit

/// Bits of the statusword beside those of the state.
namespace status_bit {
inline constexpr std::uint16_t voltage_enabled = 0x0010;  ///< the power stage has its supply
inline constexpr std::uint16_t warning = 0x0080;          ///< a value is near its limit
inline constexpr std::uint16_t remote = 0x0200;  ///< NMT state operational: the controlword counts
inline constexpr std::uint16_t target_reached = 0x0400;  ///< or halted
inline constexpr std::uint16_t internal_limit = 0x0800;  ///< the set-point was limited
/// Bits 12 and 13 depend on the mode.
inline constexpr std::uint16_t set_point_acknowledge = 0x1000;
inline constexpr std::uint16_t speed_zero = 0x1000;       ///< in profile velocity mode
inline constexpr std::uint16_t homing_attained = 0x1000;  ///< in homing mode
inline constexpr std::uint16_t following_error = 0x2000;  ///< in profile position mode
inline constexpr std::uint16_t max_slippage = 0x2000;     ///< in profile velocity mode
inline constexpr std::uint16_t homing_error = 0x2000;     ///< in homing mode
}  // namespace status_bit

/// Nothing if bit 7 is set and the other bits would not stop the drive.
constexpr std::optional<DriveCommand> drive_command(std::uint16_t word) {
  if ((word & 0x0002) == 0) return DriveCommand::disable_voltage;
  if ((word & 0x0004) == 0) return DriveCommand::quick_stop;
  if ((word & control_bit::fault_reset) != 0) return std::nullopt;
  if ((word & 0x0001) == 0) return DriveCommand::shutdown;
  if ((word & 0x0008) == 0) return DriveCommand::switch_on;
  return DriveCommand::enable_operation;
}

/// Nothing if the command has no effect. `stays` is that of the quick stop option codes 5 to 8.
constexpr std::optional<DriveState> next_state(DriveState state, DriveCommand command,
                                               bool stays = false) {
  using enum DriveState;
  const bool is_stop =
      command == DriveCommand::disable_voltage || command == DriveCommand::quick_stop;
  switch (state) {
    case switch_on_disabled:  // transition 2
      if (command == DriveCommand::shutdown) return ready_to_switch_on;
      break;
    case ready_to_switch_on:  // 7; 3, which goes on to 4 by itself
      if (is_stop) return switch_on_disabled;
      if (command == DriveCommand::switch_on) return switched_on;
      if (command == DriveCommand::enable_operation) return operation_enabled;
      break;
    case switched_on:  // 10, 6, 4
      if (is_stop) return switch_on_disabled;
      if (command == DriveCommand::shutdown) return ready_to_switch_on;
      if (command == DriveCommand::enable_operation) return operation_enabled;
      break;
    case operation_enabled:  // 9, 11, 8, 5
      if (command == DriveCommand::disable_voltage) return switch_on_disabled;
      if (command == DriveCommand::quick_stop) return quick_stop_active;
      if (command == DriveCommand::shutdown) return ready_to_switch_on;
      if (command == DriveCommand::switch_on) return switched_on;
      break;
    case quick_stop_active:  // 12, 16
      if (command == DriveCommand::disable_voltage) return switch_on_disabled;
      if (command == DriveCommand::enable_operation && stays) return operation_enabled;
      break;
    case not_ready_to_switch_on:  // only automatic transitions
    case fault_reaction_active:
    case fault:  // 15, by the edge
      break;
  }
  return std::nullopt;
}

/// Bits 0 to 3, 5 and 6 of the statusword.
constexpr std::uint16_t state_bits(DriveState state) {
  switch (state) {
    case DriveState::not_ready_to_switch_on:
      return 0x00;
    case DriveState::switch_on_disabled:
      return 0x40;
    case DriveState::ready_to_switch_on:
      return 0x21;
    case DriveState::switched_on:
      return 0x23;
    case DriveState::operation_enabled:
      return 0x27;
    case DriveState::quick_stop_active:
      return 0x07;
    case DriveState::fault_reaction_active:
      return 0x0F;
    case DriveState::fault:
      return 0x08;
  }
  return 0;
}

/// True if the power stage of the motor is on.
constexpr bool is_powered(DriveState state) {
  return state == DriveState::operation_enabled || state == DriveState::quick_stop_active ||
         state == DriveState::fault_reaction_active;
}

}  // namespace canvoy::cia417
