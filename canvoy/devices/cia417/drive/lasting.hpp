// Checks whether a condition has held without a break for a time: a velocity window (6435h to
// 6437h), a following error.
//
//     Lasting slow;
//     slow.watch(speed < threshold, now);       // each time that it was measured
//     if (slow.lasts(100ms, now)) ...
#pragma once

#include "canvoy/can/time.hpp"

namespace canvoy::cia417 {

class Lasting {
 public:
  /// Takes whether the condition holds at present.
  void watch(bool is_so, Time now) {
    if (!is_so) {
      since_ = never;
    } else if (since_ == never) {
      since_ = now;
    }
  }
  /// True if it has held for `time`, until now.
  bool lasts(Duration time, Time now) const { return since_ != never && now - since_ >= time; }
  /// Starts again: it has not held.
  void begin_anew() { since_ = never; }

 private:
  Time since_ = never;
};

}  // namespace canvoy::cia417
