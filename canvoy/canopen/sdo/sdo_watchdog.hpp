// A deadline that is postponed with each frame and rarely reached: on a host, postponing costs a
// comparison, not a change in the timer queue.
//
//     SdoWatchdog watchdog{node.timers(), Callback<void(Time)>::to<&SdoServer::give_up>(server)};
//     watchdog.restart(now + 1s);
//     if (watchdog.put_off(now)) return;  // in give_up()
#pragma once

#include "canvoy/canopen/service/timer_queue.hpp"

namespace canvoy {

/// A timer and its queue, which must outlive it.
template <bool is_small>
struct WatchdogTimer {
  /// Makes a timer that is not armed.
  constexpr WatchdogTimer(TimerQueue& timers, Callback<void(Time)> expired)
      : queue(timers), timer(expired) {}

  TimerQueue& queue;  ///< of the node
  Timer timer;        ///< armed by the watchdog
};
/// On a host, its end takes the timer out of the queue.
template <>
struct WatchdogTimer<false> : WatchdogTimer<true> {
  using WatchdogTimer<true>::WatchdogTimer;
  ~WatchdogTimer() { queue.disarm(timer); }
};

/// A watchdog. It cannot be stopped: it expires without effect. On a small machine, where servers
/// and clients live as long as their node, its end takes no code.
template <bool is_small>
class BasicSdoWatchdog {
 public:
  /// Makes a watchdog. `timers` must outlive it. `expired` is called at the deadline, or at one
  /// that was postponed since: it must call put_off() first.
  constexpr BasicSdoWatchdog(TimerQueue& timers, Callback<void(Time)> expired)
      : armed_(timers, expired) {}
  BasicSdoWatchdog(const BasicSdoWatchdog&) = delete;
  BasicSdoWatchdog& operator=(const BasicSdoWatchdog&) = delete;

  /// Sets the deadline to `at`.
  void restart(Time at) {
    // A small machine arms the timer each time.
    if constexpr (!is_small) {
      deadline_.value = at;
      if (at >= armed_.timer.at()) return;
    }
    armed_.queue.arm(armed_.timer, at);
  }

  /// Like restart(), but `delay` microseconds from the present time.
  void restart_in(std::uint32_t delay) {
    if constexpr (is_small) return armed_.queue.arm_in(armed_.timer, delay);
    restart(armed_.queue.now() + Duration(delay));
  }

  /// True if the deadline was postponed to a time still to come.
  bool put_off(Time now) {
    if (is_small || deadline_.value <= now) return false;
    armed_.queue.arm(armed_.timer, deadline_.value);
    return true;
  }

 private:
  WatchdogTimer<is_small> armed_;
  [[no_unique_address]] HostOnly<Time, !is_small> deadline_;
};
/// The watchdog of this machine.
using SdoWatchdog = BasicSdoWatchdog<is_small_machine>;

}  // namespace canvoy
