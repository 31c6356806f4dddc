// Reads the eight pre-defined messages of CiA 407 (8.1.4.3) on the wire, byte by byte, and says
// whether they carry what their table says, and what is so.
//
//     messages.is_right(now, frame, sender, truth)      // nothing: it is none of them
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/devices/cia407/bus_time.hpp"
#include "canvoy/sim/bus/true_data.hpp"

namespace canvoy::bus {

class MessageReferee {
 public:
  /// Who sends them: the main on-board computer and the identification device.
  void name(ControllerId computer, ControllerId identification) {
    computer_ = computer;
    identification_ = identification;
  }
  /// Nothing: it is none of the eight messages. What is not known is zero in them.
  std::optional<bool> is_right(Time now, ControllerId sender, const Frame& frame,
                               const TrueHistory& truth) const;
  /// Of the message with the time: whether it is the true one, or a second beside it.
  static bool is_time(const Frame& frame, const cia407::CivilTime& time);
  static constexpr std::uint32_t time_id = 0x181;

 private:
  ControllerId computer_ = no_controller;
  ControllerId identification_ = no_controller;
};

}  // namespace canvoy::bus
