// Measures for how long something was wrong without interruption, at the worst. It is judged in
// each step; what is right, or not judged, ends the interval. Where a `lull` is given, only what is
// right for longer ends it: what fails ten times a second is not right in between.
//
//     WrongTime sign;
//     sign.judge(now, sign_is_right);    // each step
//     sign.pass(now);                    // where it cannot be seen, or is excused
//     sign.rest(now);                    // where nothing could be wrong
//     if (sign.worst() > 3s) ...
#pragma once

#include <algorithm>
#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy {

class WrongTime {
 public:
  WrongTime() = default;
  /// Makes a measurement; what is right for `lull` or less does not end an interval.
  explicit WrongTime(Duration lull) : lull_(lull) {}

  /// Call it in each step.
  void judge(Time now, bool is_right) {
    measure(now, is_right);
    ++judged_;
  }
  /// Where nothing could be wrong at present: as right, but not as a judgement.
  void rest(Time now) { measure(now, true); }
  /// Does not judge; no interval extends across this time.
  void pass(Time now) {
    looked_at_ = now;
    wrong_ = {};
  }
  /// Judges, or passes where excused.
  void judge_unless(bool is_excused, Time now, bool is_right) {
    is_excused ? pass(now) : judge(now, is_right);
  }

  /// The longest interval, of which lulls are no part.
  Duration worst() const { return worst_; }
  /// Number of judgements.
  std::uint64_t judged() const { return judged_; }

 private:
  void measure(Time now, bool is_right) {
    if (!is_right) {
      wrong_ += now - looked_at_;
      wrong_at_ = now;
    } else if (now - wrong_at_ > lull_) {
      wrong_ = {};
    }
    looked_at_ = now;
    worst_ = std::max(worst_, wrong_);
  }

  Duration lull_{};
  Time looked_at_{};
  Time wrong_at_{};
  Duration wrong_{};  ///< of this interval
  Duration worst_{};
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy
