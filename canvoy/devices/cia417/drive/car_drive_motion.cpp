// How a car drive unit moves the car: what the modes of operation ask for, as profiles.
#include <algorithm>
#include <cmath>

#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"

namespace canvoy::cia417 {

using cia402::DriveMode;

/// Where the car is to be now; without power, where it is.
MotionState CarDriveUnit::present() const {
  if (has_power_) return demand(node_.now());
  return {readings_.position, readings_.velocity, 0};
}

void CarDriveUnit::follow(const MotionProfile& profile) {
  const Time now = node_.now();
  profile_ = profile;
  if (brake_released_) {
    start_ = std::max(start_, now);
  } else {
    const bool moves = profile.duration() > 0;
    start_ = moves ? now + settings_.brake_time : now;
    if (moves) release_brake();
  }
  is_standing_ = is_standing_ && !brake_released_;
  hardware_.follow(profile_, start_ - now);
  node_.timers().arm(timer_, now);
}

void CarDriveUnit::release_brake() {
  brake_released_ = true;
  hardware_.release_brake(true);
}

void CarDriveUnit::close_brake() {
  if (brake_released_) hardware_.release_brake(false);
  brake_released_ = false;
}

void CarDriveUnit::slow_down(StopReaction reaction) {
  const MotionState now = present();
  MotionLimits limits = parameters_.ramps();
  const auto by = [&](double deceleration) {
    limits.deceleration = deceleration * std::abs(parameters_.units().acceleration);
    limits.jerk = {};
    limits.type = cia402::ProfileType::linear;
  };
  switch (reaction) {
    case StopReaction::quick_stop_ramp:
    case StopReaction::quick_stop_ramp_and_stay:
      limits = parameters_.quick_stop();
      break;
    case StopReaction::current_limit:
    case StopReaction::current_limit_and_stay:
      by(settings_.current_limit_deceleration);
      break;
    case StopReaction::voltage_limit:
    case StopReaction::voltage_limit_and_stay:
      by(settings_.voltage_limit_deceleration);
      break;
    case StopReaction::disable:
      return close_brake();
    case StopReaction::slow_down_ramp:
    case StopReaction::slow_down_ramp_and_stay:
      if (std::abs(now.velocity) <= parameters_.end_velocity()) limits = parameters_.final_ramp();
      break;
  }
  velocity_goal_ = 0;
  follow(MotionProfile::to_velocity(now, 0, limits));
}

/// With power, standing, and nothing to do yet.
void CarDriveUnit::begin_operation() {
  start_ = node_.now();
  follow(MotionProfile::resting_at(readings_.position));
  take_mode();
}

/// The mode that is wanted, as far as the drive has it.
void CarDriveUnit::take_mode() {
  const auto wanted = mode_wanted_.value();
  if (wanted) mode_ = *wanted;
  mode_shown_ = mode_;
  has_arrived_ = is_acknowledged_ = is_travelling_ = is_limited_ = false;
  homing_ = Homing::idle;
  velocity_obeyed_.reset();
  change_velocity();
}

void CarDriveUnit::obey_mode(std::uint16_t word, std::uint16_t changed) {
  const bool is_halted = (word & control_bit::halt) != 0;
  if (is_halted != is_halted_) obey_halt(is_halted);
  if ((changed & control_bit::new_set_point) == 0) return;
  const bool rises = (word & control_bit::new_set_point) != 0;
  if (mode_ == DriveMode::profile_position) {
    is_acknowledged_ = false;
    if (rises) take_set_point(word);
  }
  if (mode_ != DriveMode::homing) return;
  if (rises) return start_homing();
  if (homing_ != Homing::idle) slow_down(StopReaction::slow_down_ramp);
  homing_ = Homing::idle;
}

/// The target is kept, and travelled to when the halt ends.
void CarDriveUnit::obey_halt(bool is_halted) {
  is_halted_ = is_halted;
  has_arrived_ = false;
  velocity_obeyed_.reset();
  if (is_halted) return slow_down(parameters_.option(4));
  if (mode_ == DriveMode::profile_position && is_travelling_) travel(target_, 0);
  if (mode_ == DriveMode::homing && homing_ != Homing::idle) start_homing();
  change_velocity();
}

/// What 6420h asks for, in increments. Positions count from one end of their range to the other
/// (6421h): where the car has left it, position 0 is another place; a target out of it is that in
/// it. A relative one is a way, which has no range.
double CarDriveUnit::wanted_position(bool is_relative) {
  const double from = is_travelling_ ? target_ : present().position;
  const double unit = parameters_.units().position;
  const std::int32_t target = target_position_.raw();
  if (is_relative) return from + target * unit;
  const double counted = (from - zero_) / unit;
  const double turns = counted - parameters_.in_range(counted);
  if (turns != 0) count_from(home_, zero_ + turns * unit);
  return zero_ + parameters_.in_range(target) * unit;
}

/// Acknowledged where it can be done; otherwise the drive goes on to the target that it had (4.11).
void CarDriveUnit::take_set_point(std::uint16_t word) {
  const double wanted = wanted_position((word & control_bit::relative) != 0);
  const double target =
      std::clamp(wanted, home_ + parameters_.position_min(), home_ + parameters_.position_max());
  const MotionLimits& ramps = parameters_.ramps();
  const bool is_immediate = (word & control_bit::change_immediately) != 0;
  if (is_travelling_ && !is_immediate) {
    if (next_.is_waiting) return;
    next_ = {.position = target, .is_waiting = true};
    is_acknowledged_ = true;
    const double end = parameters_.end_velocity();
    const bool goes_on = (target - target_) * (target_ - present().position) > 0;
    if (goes_on && !is_halted_) travel(target_, end);
    return;
  }
  if (is_travelling_ && !MotionProfile::can_reach(present(), target, ramps)) return;
  is_acknowledged_ = true;
  is_limited_ = target != wanted;
  next_.is_waiting = false;
  if (!is_halted_) return travel(target, 0);
  target_ = target;
  is_travelling_ = true;
}

void CarDriveUnit::travel(double target, double velocity_there) {
  target_ = target;
  is_travelling_ = true;
  has_arrived_ = false;
  follow(MotionProfile::to_position(present(), target, parameters_.ramps(), velocity_there));
}

/// Profile velocity mode: what 6430h asks for now.
void CarDriveUnit::change_velocity() {
  const bool obeys = state_ == DriveState::operation_enabled && !is_stopping_ && !is_halted_;
  const std::int32_t target = target_velocity_.raw();
  if (mode_ != DriveMode::profile_velocity || !obeys || velocity_obeyed_ == target) return;
  velocity_obeyed_ = target;
  const double wanted = target * parameters_.units().velocity;
  const double highest = parameters_.velocity_max();
  double goal = highest > 0 ? std::clamp(wanted, -highest, highest) : wanted;
  const MotionState now = present();
  const double position = now.position - home_;
  if (goal > 0 && position >= parameters_.position_max()) goal = 0;
  if (goal < 0 && position <= parameters_.position_min()) goal = 0;
  is_limited_ = goal != wanted;
  velocity_goal_ = goal;
  has_arrived_ = false;
  near_since_ = never;
  const bool is_final = goal == 0 && std::abs(now.velocity) <= parameters_.end_velocity();
  follow(MotionProfile::to_velocity(now, goal,
                                    is_final ? parameters_.final_ramp() : parameters_.ramps()));
}

void CarDriveUnit::start_homing() {
  has_homed_ = homing_failed_ = has_arrived_ = false;
  found_.reset();
  homing_ = Homing::searching;
  homing_since_ = node_.now();
  if (is_halted_) return;
  search_.begin(readings_, parameters_.units().position > 0);
  seek_home();
}

void CarDriveUnit::seek_home() {
  homing_from_ = readings_.position;
  const double speed = settings_.homing_velocity * std::abs(parameters_.units().velocity);
  follow(MotionProfile::to_velocity(present(), search_.direction() * speed, parameters_.ramps()));
}

/// Position 0 is the home offset away from the home position.
void CarDriveUnit::end_homing() {
  homing_ = Homing::idle;
  has_homed_ = found_.has_value();
  has_arrived_ = has_homed_;
  if (found_) {
    const auto offset = static_cast<double>(parameters_.home_offset());
    count_from(*found_, *found_ + offset * parameters_.units().position);
  }
  close_brake();
}

void CarDriveUnit::count_from(double home, double zero) {
  home_ = home;
  zero_ = zero;
  parameters_.set_zero((zero - home) / parameters_.units().position);
}

}  // namespace canvoy::cia417
