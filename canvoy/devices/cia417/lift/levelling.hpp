// Returns a car with open doors to its floor after its load has moved it.
//
//     if (now >= levelling.may_begin_at()) levelling.begin();
//     levelling.end(now);              // the car stands
#pragma once

#include <utility>

#include "canvoy/can/time.hpp"

namespace canvoy::cia417 {

class Levelling {
 public:
  /// After a failure, the lift continues for this time before the next attempt.
  static constexpr Duration pause = 1s;

  /// True while the car returns to its floor.
  bool is_under_way() const { return is_under_way_; }
  /// Earliest time for the next correction.
  Time may_begin_at() const { return may_begin_at_; }
  void begin() { is_under_way_ = true; }
  void end(Time now) {
    if (std::exchange(is_under_way_, false)) may_begin_at_ = now + pause;
  }
  /// Call it when something else has stopped the car.
  void give_up() { is_under_way_ = false; }

 private:
  Time may_begin_at_{};
  bool is_under_way_ = false;
};

}  // namespace canvoy::cia417
