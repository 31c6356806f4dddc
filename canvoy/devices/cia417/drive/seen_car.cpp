#include "canvoy/devices/cia417/drive/seen_car.hpp"

#include <cmath>

namespace canvoy::cia417 {

namespace {

/// Moving above this velocity, in units of the drive: more than the jitter of an encoder.
constexpr double moving_velocity = 20;

}  // namespace

double SeenCar::position() const {
  const auto counts = static_cast<std::int32_t>(position_.raw());
  return static_cast<double>(counts) * units_.position_micrometre / units_.drive_micrometre;
}

bool SeenCar::moves() const {
  return std::abs(velocity()) > moving_velocity;
}

MotionState SeenCar::state(const MotionLimits& ramps) const {
  const double now = velocity();
  const bool speeds_up = acceleration_ * now > 0 && std::abs(now) < ramps.velocity;
  const double sign = now < 0 ? -1 : 1;
  return {position(), now, speeds_up ? sign * ramps.acceleration : 0};
}

double SeenCar::nearest_stop(const MotionLimits& ramps) const {
  return position() + velocity() * std::abs(velocity()) / (2 * ramps.deceleration);
}

void SeenCar::velocity_came() {
  acceleration_ = velocity() - last_velocity_;
  last_velocity_ = velocity();
}

void SeenCar::watch_anew(Time now) {
  watched_position_ = position();
  watched_since_ = now;
}

bool SeenCar::has_moved() const {
  return std::abs(position() - watched_position_) > moving_distance;
}

}  // namespace canvoy::cia417
