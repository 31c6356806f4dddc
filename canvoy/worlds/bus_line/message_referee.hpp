// Reads the eight pre-defined messages on the wire, byte by byte, and checks that they carry what
// their table requires, and the truth (CiA 407, 8.1.4.3).
//
//     messages.is_right(now, frame, sender, truth)      // nothing: it is none of them
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/worlds/bus_line/true_data.hpp"

namespace canvoy::bus_line {

class MessageReferee {
 public:
  /// Names their senders: the main on-board computer and the identification device.
  void name(ControllerId computer, ControllerId identification) {
    computer_ = computer;
    identification_ = identification;
  }
  /// Empty where the frame is none of the eight messages. Unknown values are zero in them.
  std::optional<bool> is_right(Time now, ControllerId sender, const Frame& frame,
                               const TrueHistory& truth) const;
  /// True if the message with the time has the true time, or a second before or after it.
  static bool is_time(const Frame& frame, const cia407::CivilTime& time);
  static constexpr std::uint32_t time_id = 0x181;  ///< CAN-ID of the message with the time

 private:
  ControllerId computer_ = no_controller;
  ControllerId identification_ = no_controller;
};

}  // namespace canvoy::bus_line
