#include "canvoy/devices/cia417/drive/profile_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

void ProfilePositionMode::begin_anew() {
  give_up();
  is_acknowledged_ = is_limited_ = false;
}

void ProfilePositionMode::give_up() {
  is_travelling_ = false;
  next_.reset();
}

/// Acknowledged if it is possible; otherwise the drive continues to its former target (4.11).
bool ProfilePositionMode::take(std::uint16_t word, std::int32_t target, bool is_halted, Time now) {
  is_acknowledged_ = false;
  if ((word & control_bit::new_set_point) == 0) return false;
  const double wanted = wanted_position(target, (word & control_bit::relative) != 0, now);
  const double possible = std::clamp(wanted, parameters_.home() + parameters_.position_min(),
                                     parameters_.home() + parameters_.position_max());
  const bool is_immediate = (word & control_bit::change_immediately) != 0;
  if (is_travelling_ && !is_immediate) return wait_behind(possible, is_halted, now);
  if (is_travelling_ &&
      !MotionProfile::can_reach(car_.present(now), possible, parameters_.ramps())) {
    return false;
  }
  is_acknowledged_ = true;
  is_limited_ = possible != wanted;
  next_.reset();
  target_ = possible;
  is_travelling_ = true;
  if (is_halted) return false;
  travel(possible, 0, now);
  return true;
}

/// Passes the present target at the end velocity, if the next one is in the same direction.
bool ProfilePositionMode::wait_behind(double target, bool is_halted, Time now) {
  if (next_) return false;
  next_ = target;
  is_acknowledged_ = true;
  const bool goes_on = (target - target_) * (target_ - car_.present(now).position) > 0;
  if (!goes_on || is_halted) return false;
  travel(target_, parameters_.end_velocity(), now);
  return true;
}

/// In increments. Positions count from one end of their range to the other (6421h): if the car has
/// left it, position 0 is at another location; a target beyond the range is converted to one
/// within. A relative one is a distance, which has no range.
double ProfilePositionMode::wanted_position(std::int32_t target, bool is_relative, Time now) {
  const double from = is_travelling_ ? target_ : car_.present(now).position;
  const double unit = parameters_.units().position;
  if (is_relative) return from + target * unit;
  const double counted = (from - parameters_.zero()) / unit;
  const double turns = counted - parameters_.in_range(counted);
  if (turns != 0) parameters_.count_from(parameters_.home(), parameters_.zero() + turns * unit);
  return parameters_.zero() + parameters_.in_range(target) * unit;
}

void ProfilePositionMode::go_on(Time now) {
  if (is_travelling_) travel(target_, 0, now);
}

void ProfilePositionMode::travel(double target, double velocity_there, Time now) {
  target_ = target;
  is_travelling_ = true;
  car_.follow(
      MotionProfile::to_position(car_.present(now), target, parameters_.ramps(), velocity_there),
      now);
}

std::optional<bool> ProfilePositionMode::look(Time now) {
  if (!is_travelling_ || !car_.has_ended(now)) return std::nullopt;
  if (const std::optional<double> next = std::exchange(next_, std::nullopt)) {
    travel(*next, 0, now);
    return false;
  }
  const double off = std::abs(car_.readings().position - target_);
  if (!car_.is_standing() || off > parameters_.increments(window_)) return std::nullopt;
  is_travelling_ = false;
  car_.close_brake();
  return true;
}

}  // namespace canvoy::cia417
