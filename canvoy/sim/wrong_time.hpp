// For how long something was wrong at a stretch, at the worst: it is looked at in each step, and
// what is right, or not to be judged, ends the stretch.
//
//     WrongTime sign;
//     sign.judge(now, sign_is_right);    // each step
//     sign.pass(now);                    // where it cannot be seen, or is excused
//     if (sign.worst() > 3s) ...
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy {

class WrongTime {
 public:
  /// Called in each step.
  void judge(Time now, bool is_right) {
    if (is_right) right_at_ = now;
    worst_ = std::max(worst_, now - right_at_);
    ++judged_;
  }
  /// It is not judged, and no wrong time goes on over this.
  void pass(Time now) { right_at_ = now; }
  /// Judges it, or passes.
  void judge_unless(bool is_excused, Time now, bool is_right) {
    is_excused ? pass(now) : judge(now, is_right);
  }

  /// The longest time at a stretch.
  Duration worst() const { return worst_; }
  /// How often.
  std::uint64_t judged() const { return judged_; }

 private:
  Time right_at_{};
  Duration worst_{};
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy
