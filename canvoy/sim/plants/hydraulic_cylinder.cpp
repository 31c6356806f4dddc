#include "canvoy/sim/plants/hydraulic_cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace canvoy {

namespace {

constexpr double degrees_a_radian = 180 / std::numbers::pi;

}  // namespace

void ValveSpool::step(double command, double seconds) {
  place_ += (command - place_) * (1 - std::exp(-seconds / lag_seconds));
}

double ValveSpool::opening() const {
  const double open = std::max(0.0, std::abs(place_) - dead_band) / (1 - dead_band);
  return std::copysign(open, place_);
}

HydraulicCylinder::HydraulicCylinder(const CylinderShape& shape) : shape_(shape) {
  const double one = length_of(shape.lowest);
  const double other = length_of(shape.highest);
  shortest_ = std::min(one, other);
  longest_ = std::max(one, other);
  length_ = (shortest_ + longest_) / 2;
  angle_ = angle_of(length_);
}

double HydraulicCylinder::length_of(double angle) const {
  const double between = (angle - shape_.at_zero) * shape_.direction / degrees_a_radian;
  return std::sqrt(shape_.near_metres * shape_.near_metres + shape_.far_metres * shape_.far_metres -
                   2 * shape_.near_metres * shape_.far_metres * std::cos(between));
}

double HydraulicCylinder::angle_of(double length) const {
  const double cosine = (shape_.near_metres * shape_.near_metres +
                         shape_.far_metres * shape_.far_metres - length * length) /
                        (2 * shape_.near_metres * shape_.far_metres);
  return shape_.at_zero + shape_.direction * std::acos(cosine) * degrees_a_radian;
}

void HydraulicCylinder::step(double command, double flow, double seconds) {
  spool_.step(command, seconds);
  const double opening = spool_.opening();
  if (opening == 0) {
    speed_ = 0;
    return;
  }
  const double way = opening * flow * shape_.rate * shape_.direction * seconds;
  length_ = std::clamp(length_ + way, shortest_, longest_);
  const double before = angle_;
  angle_ = angle_of(length_);
  speed_ = (angle_ - before) / seconds;
}

}  // namespace canvoy
