// A deadline that is postponed with each frame and rarely reached: on a host, postponing costs a
// comparison, not a change in the timer queue.
//
//     SdoWatchdog watchdog{node.timers(), Callback<void(Time)>::to<&SdoServer::give_up>(server)};
//     watchdog.restart(now + 1s);
//     if (watchdog.put_off(now)) return;  // in give_up()
#pragma once

#include "canvoy/canopen/service/timer_queue.hpp"

namespace canvoy {

/// A watchdog. It cannot be stopped: it expires without effect. On a small machine, where servers
/// and clients live as long as their node, its end takes no code.
template <bool is_small>
class BasicSdoWatchdog {
 public:
  /// Makes a watchdog. `timers` must outlive it. `expired` is called at the deadline, or at one
  /// that was postponed since: it must call put_off() first.
  constexpr BasicSdoWatchdog(TimerQueue& timers, Callback<void(Time)> expired)
      : timers_(timers), timer_(expired) {}
  ~BasicSdoWatchdog()
    requires is_small
  = default;
  ~BasicSdoWatchdog() { timers_.disarm(timer_); }
  BasicSdoWatchdog(const BasicSdoWatchdog&) = delete;
  BasicSdoWatchdog& operator=(const BasicSdoWatchdog&) = delete;

  /// Sets the deadline to `at`.
  void restart(Time at) {
    // A small machine arms the timer each time.
    if constexpr (!is_small) {
      deadline_.value = at;
      if (at >= timer_.at()) return;
    }
    timers_.arm(timer_, at);
  }

  /// Like restart(), but `delay` microseconds from the present time.
  void restart_in(std::uint32_t delay) {
    if constexpr (is_small) return timers_.arm_in(timer_, delay);
    restart(timers_.now() + Duration(delay));
  }

  /// True if the deadline was postponed to a time still to come.
  bool put_off(Time now) {
    if (is_small || deadline_.value <= now) return false;
    timers_.arm(timer_, deadline_.value);
    return true;
  }

 private:
  TimerQueue& timers_;
  [[no_unique_address]] HostOnly<Time, !is_small> deadline_;
  Timer timer_;
};
/// The watchdog of this machine.
using SdoWatchdog = BasicSdoWatchdog<is_small_machine>;

}  // namespace canvoy
