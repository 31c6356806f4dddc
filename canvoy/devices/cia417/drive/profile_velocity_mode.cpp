#include "canvoy/devices/cia417/drive/profile_velocity_mode.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::cia417 {

void ProfileVelocityMode::begin_anew() {
  obeyed_.reset();
  goal_ = 0;
  is_limited_ = false;
}

bool ProfileVelocityMode::obey(std::int32_t target, Time now) {
  if (obeyed_ == target) return false;
  obeyed_ = target;
  const double wanted = target * parameters_.units().velocity;
  const double highest = parameters_.velocity_max();
  goal_ = highest > 0 ? std::clamp(wanted, -highest, highest) : wanted;
  const MotionState present = car_.present(now);
  const double position = present.position - parameters_.home();
  if (goal_ > 0 && position >= parameters_.position_max()) goal_ = 0;
  if (goal_ < 0 && position <= parameters_.position_min()) goal_ = 0;
  is_limited_ = goal_ != wanted;
  near_.begin_anew();
  const bool is_final = goal_ == 0 && std::abs(present.velocity) <= parameters_.end_velocity();
  const MotionLimits& ramps = is_final ? parameters_.final_ramp() : parameters_.ramps();
  car_.follow(MotionProfile::to_velocity(present, goal_, ramps), now);
  return true;
}

bool ProfileVelocityMode::look(Time now) {
  const DriveWindows& windows = parameters_.windows();
  near_.watch(std::abs(car_.readings().velocity - goal_) <= windows.velocity_window, now);
  watch_position_limit(now);
  if (car_.is_standing() && goal_ == 0) car_.close_brake();
  return near_.lasts(windows.velocity_window_time, now);
}

/// The car stops before it leaves the range of positions.
void ProfileVelocityMode::watch_position_limit(Time now) {
  const MotionState at = car_.demand(now);
  if (at.velocity == 0 || goal_ == 0) return;
  const double limit = parameters_.home() +
                       (at.velocity > 0 ? parameters_.position_max() : parameters_.position_min());
  const MotionLimits& ramps = parameters_.ramps();
  const double seconds = std::chrono::duration<double>(period_).count();
  const double way = std::abs(MotionProfile::stopping_distance(at, ramps)) +
                     2 * seconds * (std::abs(at.velocity) + ramps.acceleration * seconds);
  if (way < std::abs(limit - at.position)) return;
  is_limited_ = true;
  goal_ = 0;
  if (MotionProfile::can_reach(at, limit, ramps)) {
    car_.follow(MotionProfile::to_position(at, limit, ramps), now);
  } else {
    car_.slow_down(parameters_.quick_stop(), now);
  }
}

void ProfileVelocityMode::watch_slippage(Time now) {
  const auto& slippage = parameters_.windows().max_slippage;
  slips_ = slippage && car_.has_power() &&
           std::abs(car_.demand(now).velocity - car_.readings().velocity) > *slippage;
}

}  // namespace canvoy::cia417
