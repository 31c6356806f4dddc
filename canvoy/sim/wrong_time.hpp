// For how long something was wrong at a stretch, at the worst: it is looked at in each step, and
// what is right, or not to be judged, ends the stretch.
//
//     WrongTime sign;
//     sign.judge(now, sign_is_right);    // each step
//     if (sign.worst() > 3s) ...
#pragma once

#include <algorithm>

#include "canvoy/can/time.hpp"

namespace canvoy {

class WrongTime {
 public:
  void judge(Time now, bool is_right) {
    if (is_right) right_at_ = now;
    worst_ = std::max(worst_, now - right_at_);
  }
  Duration worst() const { return worst_; }

 private:
  Time right_at_{};
  Duration worst_{};
};

}  // namespace canvoy
