#include "canvoy/devices/cia417/drive/driven_car.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::cia417 {

void DrivenCar::begin_anew() {
  readings_ = hardware_.sense();
  is_standing_ = has_stood_ = has_weak_brake_ = false;
  slow_.begin_anew();
}

void DrivenCar::sense(Time now, const DriveWindows& windows, double jitter) {
  const DriveReadings before = std::exchange(readings_, hardware_.sense());
  const double past = std::chrono::duration<double>(now - measured_at_).count();
  measured_at_ = now;
  const double change = readings_.position - before.position;
  const double speed = std::abs(readings_.velocity);
  const double speed_max = std::max(speed, std::abs(before.velocity));
  if (std::abs(change) > 2 * speed_max * past + jitter) stood_at_ += change;
  slow_.watch(speed <= windows.velocity_threshold, now);
  is_slow_ = slow_.lasts(windows.velocity_threshold_time, now);
  const bool is_moved = brake_released_ && (!has_ended(now) || profile_.end().velocity != 0);
  is_standing_ = is_slow_ && !is_moved;
  if (is_standing_ && !has_stood_) settle();
  has_stood_ = !brake_released_ && (has_stood_ || is_standing_);
}

MotionState DrivenCar::present(Time now) const {
  if (has_power_) return demand(now);
  return {readings_.position, readings_.velocity, 0};
}

double DrivenCar::lag(Time now) const {
  return brake_released_ ? std::abs(demand(now).position - readings_.position) : 0;
}

bool DrivenCar::has_strayed(double distance) const {
  return has_stood_ && std::abs(readings_.position - stood_at_) > distance;
}

void DrivenCar::switch_power(bool on) {
  if (has_power_ != on) hardware_.power(on);
  has_power_ = on;
}

void DrivenCar::follow(const MotionProfile& profile, Time now) {
  profile_ = profile;
  if (brake_released_) {
    start_ = std::max(start_, now);
  } else {
    const bool moves = profile.duration() > 0;
    start_ = moves ? now + brake_time_ : now;
    if (moves) release_brake();
  }
  is_standing_ = is_standing_ && !brake_released_;
  hardware_.follow(profile_, start_ - now);
  led_();
}

void DrivenCar::slow_down(const MotionLimits& limits, Time now) {
  follow(MotionProfile::to_velocity(present(now), 0, limits), now);
}

void DrivenCar::hold(Time now) {
  start_ = now;
  follow(MotionProfile::resting_at(readings_.position), now);
}

void DrivenCar::release_brake() {
  brake_released_ = true;
  hardware_.release_brake(true);
}

void DrivenCar::close_brake() {
  if (!brake_released_) return;
  hardware_.release_brake(false);
  brake_released_ = false;
  test_brake();
}

/// A brake that stops a moving car is not tested.
void DrivenCar::test_brake() {
  if (!hardware_.brake_holds || !has_power_ || !is_standing_) return;
  has_weak_brake_ = !hardware_.brake_holds();
}

}  // namespace canvoy::cia417
