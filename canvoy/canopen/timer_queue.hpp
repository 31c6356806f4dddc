// All deadlines of a node: the next one is known at any time.
//
// A sorted list through the timers themselves: no memory beside them, and little code. To arm one
// takes a step for each that is due before it, of which a node has a few; what is put off with each
// frame (see SdoWatchdog) does not move. Timers that are due at one time expire in the order in
// which they were armed.
//
//     Timer timer{Callback<void(Time)>::to<&Heartbeat::send>(heartbeat)};
//     timers.arm(timer, now + 200ms);
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

namespace detail {

/// When a timer expires, and the run of the queue in which it was armed.
template <bool is_small>
struct Alarm {
  Time at = never;
  std::uint8_t run = 0;

  bool is_set() const { return at != never; }
  Time due() const { return at; }
  void set(Time time) { at = time; }
  void clear() { at = never; }
};
/// On a small machine in eight bytes: 55 bits of a point in time are 500 years before and after the
/// start.
template <>
struct Alarm<true> {
  std::uint32_t low = 0;
  std::uint32_t high : 23 = 0;
  std::uint32_t armed : 1 = 0;
  std::uint32_t run : 8 = 0;

  bool is_set() const { return armed != 0; }
  Time due() const {
    const std::int32_t upper = static_cast<std::int32_t>(std::uint32_t{high} << 9) >> 9;
    const auto bits = static_cast<std::uint64_t>(std::int64_t{upper}) << 32 | low;
    return Time(Duration(static_cast<Duration::rep>(bits)));
  }
  void set(Time time) {
    low = static_cast<std::uint32_t>(time.time_since_epoch().count());
    high = static_cast<std::uint32_t>(time.time_since_epoch().count() >> 32) & 0x7F'FFFFU;
    armed = time != never ? 1U : 0U;
  }
  void clear() { armed = 0; }
};

}  // namespace detail

/// One deadline, owned by whoever waits for it. It must be disarmed before its life ends.
class Timer {
 public:
  constexpr explicit Timer(Callback<void(Time)> expired = {}) : expired_(expired) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  bool armed() const { return alarm_.is_set(); }
  /// When it expires; never while it is not armed.
  Time at() const { return armed() ? alarm_.due() : never; }

 private:
  friend class TimerQueue;

  Callback<void(Time)> expired_;
  Timer* next_ = nullptr;
  detail::Alarm<is_small_machine> alarm_;
};

class TimerQueue {
 public:
  /// Arms `timer`, or moves it where it was armed before. `never` disarms it. Linear in the number
  /// of timers that are due before it.
  void arm(Timer& timer, Time at);
  /// The same in so many microseconds from now(): 64 bits are dear to a small processor, and are
  /// computed here only.
  void arm_in(Timer& timer, std::uint32_t delay);
  /// The same, unless it expires before that anyway.
  void arm_earlier(Timer& timer, std::uint32_t delay);
  void disarm(Timer& timer);

  /// Calls the timers that are due at `now`, in the order of their deadlines. A callback may arm
  /// any timer; a run ends before the first that was armed during it, so that no run is endless,
  /// and deadline() tells that another one is needed.
  void run(Time now);

  Time deadline() const { return first_ == nullptr ? never : first_->alarm_.due(); }

  /// The time of the run that is under way, or of the last one, unless it was told a later one.
  Time now() const { return now_; }
  void set_now(Time now) { now_ = now; }

 private:
  StoredTime now_{Time{}};
  Timer* first_ = nullptr;
  std::uint8_t run_ = 0;  ///< counts runs, so that one knows what was armed during it
};

}  // namespace canvoy
