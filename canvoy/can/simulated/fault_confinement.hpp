// Fault confinement of a CAN controller: the transmit and receive error counters, and the state
// that follows from them (ISO 11898-1, fault confinement; the letters are those of its list of
// rules).
//
//     ErrorCounters counters;
//     counters.transmit_error();  if (counters.state() == BusState::bus_off) ...
#pragma once

#include <cstdint>

#include "canvoy/can/port.hpp"

namespace canvoy {

/// The counters of one controller. In bus-off, only restart() changes them.
class ErrorCounters {
 public:
  /// From here on the bus counts as heavily disturbed.
  static constexpr std::uint16_t warning_limit = 96;
  static constexpr std::uint16_t passive_limit = 128;  ///< from here on error-passive
  static constexpr std::uint16_t bus_off_limit = 256;  ///< for transmit errors only

  /// Transmit error counter; 256 and up: bus-off.
  constexpr std::uint16_t transmit() const { return transmit_; }
  /// Receive error counter; a full one does not lead to bus-off.
  constexpr std::uint16_t receive() const { return receive_; }

  /// State that follows from the counters.
  constexpr BusState state() const {
    if (transmit_ >= bus_off_limit) return BusState::bus_off;
    if (reaches(passive_limit)) return BusState::error_passive;
    return reaches(warning_limit) ? BusState::error_warning : BusState::error_active;
  }

  /// Rule a: a receiver has detected an error.
  constexpr void receive_error() { raise_receive(1); }
  /// Rule b: after its error flag a receiver still sees a dominant bit, so it was the first to
  /// detect the error.
  constexpr void receive_error_alone() { raise_receive(8); }
  /// Rule c: a transmitter has sent an error flag.
  constexpr void transmit_error() {
    if (state() != BusState::bus_off) transmit_ = static_cast<std::uint16_t>(transmit_ + 8);
  }
  /// Rule c, exception 1: without acknowledgement, an error-passive transmitter does not count, so
  /// that a node alone on the bus never goes bus-off.
  constexpr void acknowledgement_missing() {
    if (is_error_active(state())) transmit_error();
  }
  /// Rule g: a frame was sent and acknowledged.
  constexpr void transmitted() {
    if (transmit_ > 0 && state() != BusState::bus_off) --transmit_;
  }
  /// Rule h: a frame was received. A counter above 127 returns to a value from 119 to 127: here,
  /// 127.
  constexpr void received() {
    if (receive_ >= passive_limit) {
      receive_ = passive_limit - 1;
    } else if (receive_ > 0) {
      --receive_;
    }
  }
  /// Resets the counters: recovered from bus-off, or switched on.
  constexpr void restart() { transmit_ = receive_ = 0; }

 private:
  constexpr bool reaches(unsigned limit) const { return transmit_ >= limit || receive_ >= limit; }
  /// A receive counter of 8 bits stays at its limit, like those of real controllers.
  constexpr void raise_receive(unsigned step) {
    if (state() == BusState::bus_off) return;
    receive_ = static_cast<std::uint16_t>(receive_ + step < 255 ? receive_ + step : 255);
  }

  std::uint16_t transmit_ = 0;
  std::uint16_t receive_ = 0;
};

}  // namespace canvoy
