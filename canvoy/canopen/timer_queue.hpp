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

#include <algorithm>
#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy {

namespace detail {

/// When a timer expires, and the run of the queue in which it was armed.
template <bool is_small>
class Alarm {
 public:
  Alarm() = default;
  Alarm(Time, Time at) : at_(at) {}
  Alarm(Time now, std::uint32_t delay) : at_(now + Duration(delay)) {}

  bool is_set() const { return at_ != never; }
  bool is_before(const Alarm& other) const { return canvoy::is_before(at_, other.at_); }
  bool is_due(Time now) const { return !canvoy::is_before(now, at_); }
  bool put_off() { return false; }
  Time at(Time) const { return at_; }

 private:
  Time at_ = never;

 public:
  std::uint8_t run = 0;
};

/// On a small machine in eight bytes: the low bits of the time, and how often it is put off by a
/// lap, so that the next time is never so far away that it would seem to be near again.
template <>
class Alarm<true> {
 public:
  Alarm() = default;
  Alarm(Time now, Time at) : Alarm(now, std::max(at - now, Duration::zero()).count()) {}
  Alarm(Time now, std::uint32_t delay) : Alarm(low_ticks(now), delay % lap, delay / lap) {}

  bool is_set() const { return is_set_; }
  bool is_before(const Alarm& other) const { return is_before(at_, other.at_); }
  bool is_due(Time now) const { return !is_before(low_ticks(now), at_); }
  /// Whether laps are left, and then by one of them.
  bool put_off() {
    if (laps_ == 0) return false;
    --laps_;
    at_ += lap;
    return true;
  }
  Time at(Time now) const {
    const auto left = static_cast<std::int32_t>(at_ - low_ticks(now));
    return now + Duration(left) + laps_ * Duration(lap);
  }

 private:
  static constexpr std::uint32_t lap = 0x4000'0000;  ///< 18 minutes

  Alarm(Time now, Duration::rep delay)
      : Alarm(low_ticks(now), static_cast<std::uint32_t>(delay % lap),
              static_cast<std::uint32_t>(std::min<Duration::rep>(delay / lap, UINT16_MAX))) {}
  Alarm(std::uint32_t now, std::uint32_t delay, std::uint32_t laps)
      : at_(now + delay), laps_(static_cast<std::uint16_t>(laps)), is_set_(true) {}
  static bool is_before(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::int32_t>(a - b) < 0;
  }

  std::uint32_t at_ = 0;
  std::uint16_t laps_ = 0;

 public:
  std::uint8_t run = 0;

 private:
  bool is_set_ = false;
};

}  // namespace detail

/// One deadline, owned by whoever waits for it. It must be disarmed before its life ends.
class Timer {
 public:
  explicit Timer(Callback<void(Time)> expired = {}) : expired_(expired) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  bool armed() const { return alarm_.is_set(); }

 private:
  friend class TimerQueue;

  Callback<void(Time)> expired_;
  Timer* next_ = nullptr;
  detail::Alarm<is_small_machine> alarm_;
};

class TimerQueue {
 public:
  /// Arms `timer`, or moves it where it was armed before. `never` disarms it. Linear in the number
  /// of timers that are due before it. On a small machine one that is due at a past time is due
  /// now, and one that is due after more than two years expires then.
  void arm(Timer& timer, Time at);
  /// The same in so many microseconds from now().
  void arm_in(Timer& timer, std::uint32_t delay);
  /// The same, unless it expires before that anyway.
  void arm_earlier(Timer& timer, std::uint32_t delay);
  void disarm(Timer& timer);

  /// Calls the timers that are due at `now`, in the order of their deadlines. A callback may arm
  /// any timer; a run ends before the first that was armed during it, so that no run is endless,
  /// and deadline() tells that another one is needed.
  void run(Time now);

  /// When to call run(). On a small machine in 18 minutes at the latest, where a timer is armed.
  Time deadline() const { return first_ == nullptr ? never : at(*first_); }
  /// When it expires; never while it is not armed.
  Time at(const Timer& timer) const { return timer.armed() ? timer.alarm_.at(now_) : never; }

  Time now() const { return now_; }
  void set_now(Time now) { now_ = now; }

 private:
  using Alarm = detail::Alarm<is_small_machine>;

  void insert(Timer& timer, const Alarm& alarm);

  StoredTime now_{Time{}};
  Timer* first_ = nullptr;
  std::uint8_t run_ = 0;  ///< counts runs, so that one knows what was armed during it
};

}  // namespace canvoy
