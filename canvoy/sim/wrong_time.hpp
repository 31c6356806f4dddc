// For how long something was wrong at a stretch, at the worst: it is looked at in each step, and
// what is right, or not to be judged, ends the stretch. Where a `lull` is given, only what is right
// for longer ends it: what goes wrong ten times a second is not right in between.
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
  WrongTime() = default;
  explicit WrongTime(Duration lull) : lull_(lull) {}

  /// Called in each step.
  void judge(Time now, bool is_right) {
    if (!is_right) {
      wrong_ += now - looked_at_;
      wrong_at_ = now;
    } else if (now - wrong_at_ > lull_) {
      wrong_ = {};
    }
    looked_at_ = now;
    worst_ = std::max(worst_, wrong_);
    ++judged_;
  }
  /// It is not judged, and no wrong time goes on over this.
  void pass(Time now) {
    looked_at_ = now;
    wrong_ = {};
  }
  /// Judges it, or passes.
  void judge_unless(bool is_excused, Time now, bool is_right) {
    is_excused ? pass(now) : judge(now, is_right);
  }

  /// The longest time at a stretch, of which lulls are no part.
  Duration worst() const { return worst_; }
  /// How often.
  std::uint64_t judged() const { return judged_; }

 private:
  Duration lull_{};
  Time looked_at_{};
  Time wrong_at_{};
  Duration wrong_{};  ///< at this stretch
  Duration worst_{};
  std::uint64_t judged_ = 0;
};

}  // namespace canvoy
