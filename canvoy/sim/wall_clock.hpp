// Time of day in a simulated world: the time on the wall clock when the world began, plus the time
// that has passed.
//
//     WallClock clock(world, sys_days{2026y / 11 / 21} + 18h);
//     hardware.time_of_day = Callback<std::optional<TimeOfDay>()>::to<&WallClock::now>(clock);
#pragma once

#include <optional>

#include "canvoy/canopen/sync/time_of_day.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy {

class WallClock {
 public:
  /// `world` must outlive this object.
  WallClock(const World& world, CivilTime at_begin) : world_(world), at_begin_(at_begin) {}

  /// Empty beyond the range of a TIME message.
  std::optional<TimeOfDay> now() const {
    return to_time_of_day(
        at_begin_ + std::chrono::floor<std::chrono::milliseconds>(world_.now().time_since_epoch()));
  }

 private:
  const World& world_;
  CivilTime at_begin_;
};

}  // namespace canvoy
