// One piece of cable of the simulated bus and the frame that is on it. A bus has one, until its
// cable is cut.
//
//     wire.plan_failure(wire.bit_end_ns(17), BusErrorKind::bit, detector);
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "canvoy/can/bus_load.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/simulated/transmit_queue.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// How an error shows first (ISO 11898-1, error detection).
enum class BusErrorKind : std::uint8_t {
  bit,              ///< a transmitter reads another bit than it sends
  stuff,            ///< a receiver sees six equal bits
  acknowledgement,  ///< nobody has received the frame
};

/// A frame that was destroyed.
struct BusError {
  BusErrorKind kind = BusErrorKind::bit;
  ControllerId sender = no_controller;    ///< no_controller: it has gone
  ControllerId detector = no_controller;  ///< the first to see it; no_controller: the sender
  unsigned bit = 0;  ///< up to which the frame was sent, counted from 1 at the start of frame
  Frame frame{};
};

/// Counted since the construction of the bus.
struct BusStatistics {
  std::uint64_t frames = 0;
  std::uint64_t frame_bits = 0;  ///< of these frames, with stuff bits, without intermissions
  std::uint64_t error_frames = 0;
};

/// Wire time in nanoseconds: every bit rate of CiA 301 has a bit time without remainder.
inline constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();

/// Converted from and to the time of the world. Nothing is seen before it has happened: rounded up.
constexpr std::int64_t to_ns(Time time) {
  const std::int64_t us = time.time_since_epoch().count();
  return us > never_ns / 1000 ? never_ns : us * 1000;
}
constexpr Time to_time(std::int64_t ns) {
  return ns == never_ns ? never : Time(Duration((ns + 999) / 1000));
}

/// Of 1000 to 1'000'000 bit/s, rounded to the nanosecond; what is beyond is taken to the limit.
constexpr std::int64_t bit_time_ns(std::uint32_t bit_rate) {
  const std::int64_t rate = std::clamp<std::uint32_t>(bit_rate, 1000, 1'000'000);
  return (1'000'000'000 + rate / 2) / rate;
}

/// Recessive bits that an error-passive transmitter waits, beyond the intermission, before it sends
/// again.
inline constexpr unsigned suspend_bits = 8;

struct SimulatedWire {
  /// What the next event is: a start of frame, receivers having the frame, the end of it. While a
  /// transmitter is told that it has ended, the next is not yet known.
  enum class Phase : std::uint8_t { idle, frame, last_bit, ended };

  Phase phase = Phase::idle;
  BusErrorKind failure_kind = BusErrorKind::bit;
  ControllerSet members{};       ///< with power or without
  ControllerSet transmitters{};  ///< of the frame on the wire: one, or more that send the same
  ControllerSet receivers{};     ///< of the frame on the wire
  ControllerSet suspended{};     ///< error-passive, and the last to send: they let others go first
  ControllerSet detectors{};  ///< of the error that is going to be detected; none: the transmitters

  PendingFrame current{};
  std::int64_t bit_ns = 0;             ///< of the frame on the wire, or the last one
  std::int64_t begin_ns = 0;           ///< of the start of frame
  std::int64_t event_ns = never_ns;    ///< what is due next
  std::int64_t start_ns = never_ns;    ///< while idle: of the next start of frame
  std::int64_t failure_ns = never_ns;  ///< when an error is going to be detected
  std::int64_t free_ns = 0;            ///< end of the intermission
  std::int64_t recessive_since_ns = 0;
  BusLoad load{};

  bool is_busy() const { return phase == Phase::frame || phase == Phase::last_bit; }
  std::int64_t bit_end_ns(unsigned bit) const { return begin_ns + bit * bit_ns; }
  /// The acknowledgement slot, in which the transmitter learns whether anybody has the frame.
  std::int64_t acknowledgement_ns() const {
    return bit_end_ns(current.bits - bits_after_acknowledgement);
  }
  std::int64_t suspended_until_ns() const { return free_ns + suspend_bits * bit_ns; }

  /// An error that `detector` is going to see, or, where that is no_controller, the transmitters.
  /// The earliest counts; several may see one at the same time.
  void plan_failure(std::int64_t at_ns, BusErrorKind kind, ControllerId detector) {
    if (at_ns > failure_ns) return;
    if (at_ns < failure_ns) detectors.clear();
    failure_ns = at_ns;
    failure_kind = kind;
    if (detector != no_controller) detectors.insert(detector);
  }
};

}  // namespace canvoy
