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

/// One deadline, owned by whoever waits for it. It must be disarmed before its life ends.
class Timer {
 public:
  explicit Timer(Callback<void(Time)> expired = {}) : expired_(expired) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  bool armed() const { return at_ != never; }
  /// When it expires; never while it is not armed.
  Time at() const { return at_; }

 private:
  friend class TimerQueue;

  Callback<void(Time)> expired_;
  Time at_ = never;
  Timer* next_ = nullptr;
  std::uint8_t run_ = 0;  ///< of the queue, when it was armed
};

class TimerQueue {
 public:
  /// Arms `timer`, or moves it where it was armed before. `never` disarms it. Linear in the number
  /// of timers that are due before it.
  void arm(Timer& timer, Time at);
  void disarm(Timer& timer) { arm(timer, never); }

  /// Calls the timers that are due at `now`, in the order of their deadlines. A callback may arm
  /// any timer; a run ends before the first that was armed during it, so that no run is endless,
  /// and deadline() tells that another one is needed.
  void run(Time now);

  Time deadline() const { return first_ == nullptr ? never : first_->at_; }

 private:
  Timer* first_ = nullptr;
  std::uint8_t run_ = 0;  ///< counts runs, so that one knows what was armed during it
};

}  // namespace canvoy
