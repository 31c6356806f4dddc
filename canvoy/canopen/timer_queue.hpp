// All deadlines of a node: the next one is known at any time.
//
// Through the timers themselves, so that no memory is beside them: on a host a pairing heap, in
// which a timer is armed in constant time, beside however many others; on a small machine a sorted
// list, for little code: to arm one takes a step for each that is due before it, of which a node
// has a few. What is put off with each frame (see SdoWatchdog) does not move. Timers that are due
// at one time expire in the order in which they were armed.
//
//     Timer timer{Callback<void(Time)>::to<&Heartbeat::send>(heartbeat)};
//     timers.arm(timer, now + 200ms);
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/machine.hpp"
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

  /// In the heap.
  struct Place {
    Timer* child = nullptr;     ///< the first of those that expire after it
    Timer* previous = nullptr;  ///< sibling, or the parent of the first one
    std::uint64_t order = 0;    ///< counts all that were armed
  };

  Callback<void(Time)> expired_;
  Timer* next_ = nullptr;  ///< in the list; sibling in the heap
  detail::Alarm<is_small_machine> alarm_;
  [[no_unique_address]] HostOnly<Place> place_;
};

class TimerQueue {
 public:
  /// Arms `timer`, or moves it where it was armed before. `never` disarms it. Constant where it was
  /// not armed; to take it from its old place, and to expire, is logarithmic in the number of
  /// timers on average. On a small machine linear in the number of those that are due before it.
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
  void run(Time now) {
    if (!is_small_machine && is_before(now, deadline())) {
      now_ = now;
    } else {
      run_due(now);
    }
  }

  Time deadline() const { return first_ == nullptr ? never : first_->alarm_.due(); }

  /// The time of the run that is under way, or of the last one, unless it was told a later one.
  Time now() const { return now_; }
  void set_now(Time now) { now_ = now; }

 private:
  void run_due(Time now);
  static bool precedes(const Timer& one, const Timer& other);
  static Timer* meld(Timer* one, Timer* other);
  static Timer* meld_all(Timer* siblings);
  void put_in(Timer& timer);
  void take_out(Timer& timer);

  StoredTime now_{Time{}};
  Timer* first_ = nullptr;
  [[no_unique_address]] HostOnly<std::uint64_t> armed_;  ///< how many were
  std::uint8_t run_ = 0;  ///< counts runs, so that one knows what was armed during it
};

}  // namespace canvoy
