// Holder of a part of the terminal: the car's own application, or the add-on device that has locked
// it (CiA 447-3, 4.2.9). One device at a time holds a part; other devices that lock it, or write to
// it, are refused until the holder releases it, or is lost.
//
//     PartLock display;
//     display.command(AccessCommand::lock, 4);  // AbortCode::none: node 4 has it
//     display.command(AccessCommand::lock, 7);  // AbortCode::device_state
//     display.access();                         // TerminalAccess::device_4
#pragma once

#include <cstdint>

#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

class PartLock {
 public:
  /// Car add-on device N is the one with node-ID N.
  static constexpr unsigned devices_max = 16;

  /// True while a device holds the part.
  constexpr bool is_held() const { return holder_ != 0; }
  /// True while this device holds the part.
  constexpr bool is_held_by(unsigned node_id) const { return is_held() && holder_ == node_id; }
  /// 0: none.
  constexpr unsigned holder() const { return holder_; }

  /// As in the status objects while the part works.
  constexpr TerminalAccess access() const {
    const auto vehicle = static_cast<unsigned>(TerminalAccess::vehicle);
    return static_cast<TerminalAccess>(vehicle + holder_);
  }

  /// Checks whether `node_id` may give this command. Aborts: device_state (0800 0022h) while
  /// another device holds the part, or if the status has no code for a device with this node-ID.
  constexpr AbortCode check(AccessCommand command, unsigned node_id) const {
    if (command == AccessCommand::do_not_care) return AbortCode::none;
    if (is_held() && !is_held_by(node_id)) return AbortCode::device_state;
    const bool has_code = node_id >= 1 && node_id <= devices_max;
    return locks(command) && !has_code ? AbortCode::device_state : AbortCode::none;
  }
  /// Checks the command, and executes it. Releasing a free part changes nothing.
  constexpr AbortCode command(AccessCommand command, unsigned node_id) {
    const AbortCode answer = check(command, node_id);
    if (answer != AbortCode::none || command == AccessCommand::do_not_care) return answer;
    holder_ = static_cast<std::uint8_t>(locks(command) ? node_id : 0);
    return AbortCode::none;
  }

  /// Takes the loss of a device. True if it was the holder, and the part belongs to the car again.
  constexpr bool lose(unsigned node_id) {
    if (!is_held_by(node_id)) return false;
    holder_ = 0;
    return true;
  }
  /// Releases the part.
  constexpr void reset() { holder_ = 0; }

 private:
  /// The lock for contents by ISO-TP is a lock (display 1 only, errata A7).
  static constexpr bool locks(AccessCommand command) {
    return command == AccessCommand::lock || command == AccessCommand::lock_for_iso_tp;
  }

  std::uint8_t holder_ = 0;
};

}  // namespace canvoy::cia447
