// Observers of the whole simulated bus: loggers, referees, and the count of all frames.
//
//     BusObservers observers;
//     observers.add({.context = &log, .on_frame = write_line});
//     observers.frame_carried(now, sender, frame, frame_bits(frame));
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/simulated/bus_error.hpp"
#include "canvoy/can/simulated/controller_set.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

/// Callbacks of an observer of the whole bus, called at the moment of an event and before the
/// nodes. Null: not called.
struct BusTap {
  void* context = nullptr;  ///< first argument of each call
  /// A frame was sent completely; `now` is the time at which receivers have it.
  void (*on_frame)(void* context, Time now, ControllerId sender, const Frame& frame) = nullptr;
  /// A frame was destroyed; an error frame follows on the wire.
  void (*on_error)(void* context, Time now, const BusError& error) = nullptr;
  /// The state of a controller has changed.
  void (*on_state)(void* context, Time now, ControllerId controller, BusState state) = nullptr;
  /// A controller lost a frame because its receive queue was full.
  void (*on_overrun)(void* context, Time now, ControllerId controller) = nullptr;
};

/// Counters since the construction of the bus.
struct BusStatistics {
  std::uint64_t frames = 0;      ///< sent completely
  std::uint64_t frame_bits = 0;  ///< length of these frames, with stuff bits, without intermissions
  std::uint64_t error_frames = 0;  ///< one for each frame that was destroyed
};

/// Notifies all taps, in the order in which they were added, and counts.
class BusObservers {
 public:
  static constexpr std::size_t taps_max = 4;  ///< observers

  /// Adds a tap. False if there are taps_max already.
  constexpr bool add(const BusTap& tap) {
    if (count_ == taps_max) return false;
    taps_[count_++] = tap;
    return true;
  }
  /// Counts so far.
  constexpr const BusStatistics& statistics() const { return statistics_; }

  /// Counts a frame that was sent; its length in bits is with stuff bits.
  void frame_carried(Time now, ControllerId sender, const Frame& frame, unsigned bits) {
    ++statistics_.frames;
    statistics_.frame_bits += bits;
    for (const BusTap& tap : taps()) {
      if (tap.on_frame != nullptr) tap.on_frame(tap.context, now, sender, frame);
    }
  }
  /// Counts a frame that was destroyed.
  void frame_destroyed(Time now, const BusError& error) {
    ++statistics_.error_frames;
    for (const BusTap& tap : taps()) {
      if (tap.on_error != nullptr) tap.on_error(tap.context, now, error);
    }
  }
  /// Passes a change of state on; counts nothing.
  void state_changed(Time now, ControllerId controller, BusState state) const {
    for (const BusTap& tap : taps()) {
      if (tap.on_state != nullptr) tap.on_state(tap.context, now, controller, state);
    }
  }
  /// Passes a lost frame on; counts nothing.
  void frame_lost(Time now, ControllerId controller) const {
    for (const BusTap& tap : taps()) {
      if (tap.on_overrun != nullptr) tap.on_overrun(tap.context, now, controller);
    }
  }

 private:
  std::span<const BusTap> taps() const { return std::span(taps_).first(count_); }

  std::array<BusTap, taps_max> taps_{};
  std::size_t count_ = 0;
  BusStatistics statistics_{};
};

}  // namespace canvoy
