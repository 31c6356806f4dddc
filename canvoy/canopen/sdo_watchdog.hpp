// A deadline that is put off with each frame and hardly ever reached: to put it off costs a
// comparison, not a change in the timer queue.
//
//     SdoWatchdog watchdog{node.timers(), Callback<void()>::to<&SdoServer::give_up>(server)};
//     watchdog.restart(now + 1s);
#pragma once

#include "canvoy/canopen/timer_queue.hpp"

namespace canvoy {

/// It cannot be stopped: who has nothing to wait for any more lets it expire.
class SdoWatchdog {
 public:
  /// `timers` must outlive the watchdog.
  SdoWatchdog(TimerQueue& timers, Callback<void()> expired) : timers_(timers), expired_(expired) {}
  ~SdoWatchdog() { timers_.disarm(timer_); }
  SdoWatchdog(const SdoWatchdog&) = delete;
  SdoWatchdog& operator=(const SdoWatchdog&) = delete;

  /// From now on it expires at `at`, and not before.
  void restart(Time at) {
    at_ = at;
    if (at < timer_.at()) timers_.arm(timer_, at);
  }

 private:
  void check(Time now) {
    if (at_ > now) return timers_.arm(timer_, at_);
    expired_();
  }

  TimerQueue& timers_;
  Callback<void()> expired_;
  Time at_{};
  Timer timer_{Callback<void(Time)>::to<&SdoWatchdog::check>(*this)};
};

}  // namespace canvoy
