// All deadlines of a node: the next one is known at any time, and arming one costs a few pointer
// moves.
//
// A pairing heap through the timers themselves: no memory beside them, constant time to arm,
// amortised logarithmic time to disarm or expire. Timers that are due at one time expire in the
// order in which they were armed.
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

  bool armed() const { return armed_; }
  /// When it expires; never while it is not armed.
  Time at() const { return armed_ ? at_ : never; }

 private:
  friend class TimerQueue;
  bool before(const Timer& other) const {
    return at_ != other.at_ ? at_ < other.at_ : order_ < other.order_;
  }

  Callback<void(Time)> expired_;
  Time at_{};
  std::uint64_t order_ = 0;
  Timer* child_ = nullptr;
  Timer* sibling_ = nullptr;
  Timer* previous_ = nullptr;  ///< the left sibling, or the parent of a first child
  bool armed_ = false;
};

class TimerQueue {
 public:
  /// Arms `timer`, or moves it where it was armed before. `never` disarms it.
  void arm(Timer& timer, Time at);
  void disarm(Timer& timer);

  /// Calls the timers that are due at `now`, in the order of their deadlines. A callback may arm
  /// any timer; a run ends before the first that was armed during it, so that no run is endless,
  /// and deadline() tells that another one is needed.
  void run(Time now);

  Time deadline() const { return root_ == nullptr ? never : root_->at_; }

 private:
  static Timer* meld(Timer* a, Timer* b);
  static Timer* merge_siblings(Timer* first);
  void unlink(Timer& timer);

  Timer* root_ = nullptr;
  std::uint64_t order_ = 0;
};

}  // namespace canvoy
