// A deadline that is put off with each frame and hardly ever reached: to put it off costs a
// comparison, not a change in the timer queue.
//
//     SdoWatchdog watchdog{node.timers(), Callback<void()>::to<&SdoServer::give_up>(server)};
//     watchdog.restart(now + 1s);
#pragma once

#include "canvoy/canopen/timer_queue.hpp"

namespace canvoy {

/// The timer behind it may stay armed after stop(): it expires once, and nothing happens.
class SdoWatchdog {
 public:
  /// `timers` must outlive the watchdog.
  SdoWatchdog(TimerQueue& timers, Callback<void()> expired) : timers_(timers), expired_(expired) {}
  ~SdoWatchdog() { timers_.disarm(timer_); }
  SdoWatchdog(const SdoWatchdog&) = delete;
  SdoWatchdog& operator=(const SdoWatchdog&) = delete;

  /// From now on it expires at `at`, and no sooner.
  void restart(Time at) {
    at_ = at;
    if (at < timer_.at()) timers_.arm(timer_, at);
  }
  void stop() { at_ = never; }

 private:
  void check(Time now) {
    if (at_ > now) return timers_.arm(timer_, at_);
    at_ = never;
    expired_();
  }

  TimerQueue& timers_;
  Callback<void()> expired_;
  Time at_ = never;
  Timer timer_{Callback<void(Time)>::to<&SdoWatchdog::check>(*this)};
};

}  // namespace canvoy
