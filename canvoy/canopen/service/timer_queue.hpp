// All deadlines of a node; the next one is available at any time.
//
// The queue links the timers themselves, and so needs no other memory. On a host it is a pairing
// heap, in which a timer is armed in constant time, however many others there are. On a small
// machine it is a sorted list, for small code: to arm a timer takes a step for each of the few that
// are due before it. A deadline that is postponed with each frame (see SdoWatchdog) does not move.
// Timers that are due at one time expire in the order in which they were armed.
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

/// Time at which a timer expires, and the run of the queue in which it was armed.
template <bool is_small>
struct Alarm {
  Time at = never;
  std::uint8_t run = 0;

  bool is_set() const { return at != never; }
  Time due() const { return at; }
  void set(Time time) { at = time; }
  void clear() { at = never; }
};
/// On a small machine in eight bytes: 55 bits of time cover 500 years before and after the start.
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

/// One deadline, owned by the object that waits for it. It must be disarmed before its life ends.
class Timer {
 public:
  /// Makes a timer that is not armed. `expired` gets the time of the run, which may be later than
  /// at().
  constexpr explicit Timer(Callback<void(Time)> expired = {}) : expired_(expired) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  /// True from TimerQueue::arm() until it expires or is disarmed.
  bool armed() const { return alarm_.is_set(); }
  /// Time at which it expires; never while it is not armed.
  Time at() const { return armed() ? alarm_.due() : never; }

 private:
  friend class TimerQueue;

  /// Position in the heap.
  struct Place {
    Timer* child = nullptr;     ///< first of the timers that expire after it
    Timer* previous = nullptr;  ///< sibling, or the parent of the first sibling
    std::uint64_t order = 0;    ///< sequence number of arming
  };

  Callback<void(Time)> expired_;
  Timer* next_ = nullptr;  ///< next in the list; sibling in the heap
  detail::Alarm<is_small_machine> alarm_;
  [[no_unique_address]] HostOnly<Place> place_;
};

/// The timers of one node, by their deadlines.
class TimerQueue {
 public:
  /// Arms `timer`, or moves it if it was armed before. `never` disarms it. Constant if it was not
  /// armed; to remove it from its old place, and to expire, is logarithmic in the number of timers
  /// on average. On a small machine linear in the number of timers due before it.
  void arm(Timer& timer, Time at);
  /// Like arm(), but `delay` microseconds after now(): 64-bit arithmetic is slow on a small
  /// processor, and is done only here.
  void arm_in(Timer& timer, std::uint32_t delay);
  /// Like arm_in(), but without effect if the timer expires before that anyway.
  void arm_earlier(Timer& timer, std::uint32_t delay);
  /// Disarms a timer; no effect if it is not armed. Costs as much as to move it: see arm().
  void disarm(Timer& timer);

  /// Calls the timers that are due at `now`, in the order of their deadlines. A callback may arm
  /// any timer; a run ends before the first timer that was armed during it, so that no run is
  /// endless, and deadline() shows that another run is needed.
  void run(Time now) {
    if (!is_small_machine && is_before(now, deadline())) {
      now_ = now;
    } else {
      run_due(now);
    }
  }

  /// Deadline of the first timer; never if none is armed. Constant time.
  Time deadline() const { return first_ == nullptr ? never : first_->alarm_.due(); }

  /// Time of the run that is under way, or of the last one, unless a later time was set.
  Time now() const { return now_; }
  /// Sets the time that arm_in() counts from, without running timers.
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
  [[no_unique_address]] HostOnly<std::uint64_t> armed_;  ///< number of timers armed so far
  std::uint8_t run_ = 0;  ///< counts runs, to recognise timers that were armed during one
};

}  // namespace canvoy
