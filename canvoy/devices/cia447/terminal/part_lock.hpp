// Who has a part of the terminal: the car's own application, or the add-on device that has locked
// it (CiA 447-3, 4.2.9). A part is held by one device at a time; another one that wants it, or
// writes to it, is refused until the holder lets go, or dies.
//
//     PartLock display;
//     display.command(AccessCommand::lock, 4);  // AbortCode::none: node 4 has it
//     display.command(AccessCommand::lock, 7);  // AbortCode::device_state
//     display.access();                         // TerminalAccess::device_4
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/abort_code.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447 {

class PartLock {
 public:
  /// Car add-on device N is the one with node-ID N.
  static constexpr unsigned devices_max = 16;

  constexpr bool is_held() const { return holder_ != 0; }
  constexpr bool is_held_by(unsigned node_id) const { return is_held() && holder_ == node_id; }
  /// 0: nobody.
  constexpr unsigned holder() const { return holder_; }

  /// As the status objects show it while the part works.
  constexpr TerminalAccess access() const {
    const auto vehicle = static_cast<unsigned>(TerminalAccess::vehicle);
    return static_cast<TerminalAccess>(vehicle + holder_);
  }

  /// Whether `node_id` may give this command. Aborts: device_state (0800 0022h) while another
  /// device holds the part, or where the status has no code for a device with this node-ID.
  constexpr AbortCode check(AccessCommand command, unsigned node_id) const {
    if (command == AccessCommand::do_not_care) return AbortCode::none;
    if (is_held() && !is_held_by(node_id)) return AbortCode::device_state;
    const bool has_code = node_id >= 1 && node_id <= devices_max;
    return locks(command) && !has_code ? AbortCode::device_state : AbortCode::none;
  }
  /// The same, and follows it. A release of what nobody holds changes nothing.
  constexpr AbortCode command(AccessCommand command, unsigned node_id) {
    const AbortCode answer = check(command, node_id);
    if (answer != AbortCode::none || command == AccessCommand::do_not_care) return answer;
    holder_ = static_cast<std::uint8_t>(locks(command) ? node_id : 0);
    return AbortCode::none;
  }

  /// A device has died. True: it was the holder, and the part is the car's again.
  constexpr bool lose(unsigned node_id) {
    if (!is_held_by(node_id)) return false;
    holder_ = 0;
    return true;
  }
  constexpr void reset() { holder_ = 0; }

 private:
  /// The lock for content that comes by ISO-TP is a lock (display 1 only, errata A7).
  static constexpr bool locks(AccessCommand command) {
    return command == AccessCommand::lock || command == AccessCommand::lock_for_iso_tp;
  }

  std::uint8_t holder_ = 0;
};

}  // namespace canvoy::cia447
