#include "canvoy/sim/plants/excavator.hpp"

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

namespace {

constexpr Excavator::Point boom_foot{0.2, 1.8};
constexpr double boom_metres = 5.7;
constexpr double stick_metres = 2.9;
constexpr double bucket_metres = 1.4;
constexpr double bucket_width = 1.2;
constexpr double cut_max = 0.4;         ///< m of depth that the bucket cuts into the ground
constexpr double pours_above = -30;     ///< degrees of the bucket to its stick
constexpr double pours_a_second = 1.5;  ///< m3

constexpr double slew_max = 36;            ///< degrees per second
constexpr double slew_acceleration = 240;  ///< degrees per second squared
constexpr double rotator_max = 45;
constexpr double track_max = 1.0;  ///< m/s
constexpr double fast_track_max = 1.6;
constexpr double way_to_new_place = 2;  ///< m

constexpr double idle_rpm = 800;
constexpr double full_rpm = 2000;
constexpr double rpm_lag = 0.5;  ///< s
constexpr double litres_an_hour_idle = 4;
constexpr double litres_an_hour_full = 22;
constexpr double oil_lag = 1200;  ///< s
constexpr double oil_at_rest = 30;
constexpr double oil_at_work = 75;
constexpr double pressure_at_rest = 30;
constexpr double pressure_at_work = 320;
constexpr double seconds_an_hour = 3600;

Excavator::Point from(Excavator::Point start, double metres, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  return {start.x + metres * std::cos(radians), start.z + metres * std::sin(radians)};
}

}  // namespace

double Excavator::angle(Movement movement) const {
  switch (movement) {
    case Movement::slew:
      return slew_;
    case Movement::stick:
      return stick_.angle();
    case Movement::boom:
      return boom_.angle();
    case Movement::bucket:
      return bucket_.angle();
    case Movement::left_track:
      return tracks_[0];
    case Movement::right_track:
      return tracks_[1];
    case Movement::rotator:
      return rotator_;
  }
  return 0;
}

Excavator::Point Excavator::joint(Movement movement) const {
  if (movement == Movement::boom) return boom_foot;
  const Point end_of_boom = from(boom_foot, boom_metres, boom_.angle());
  if (movement == Movement::stick) return end_of_boom;
  return from(end_of_boom, stick_metres, boom_.angle() + stick_.angle());
}

Excavator::Point Excavator::tip_at(double boom, double stick, double bucket) {
  const Point end_of_boom = from(boom_foot, boom_metres, boom);
  const Point end_of_stick = from(end_of_boom, stick_metres, boom + stick);
  return from(end_of_stick, bucket_metres, boom + stick + bucket);
}

Excavator::Point Excavator::tip() const {
  return tip_at(boom_.angle(), stick_.angle(), bucket_.angle());
}

void Excavator::step(double seconds) {
  const Point before = tip();
  step_engine(seconds);
  step_cylinder(boom_, Movement::boom, seconds);
  step_cylinder(stick_, Movement::stick, seconds);
  step_cylinder(bucket_, Movement::bucket, seconds);
  step_turns(seconds);
  step_earth(before, seconds);
}

void Excavator::step_engine(double seconds) {
  const double wanted_rpm = litres_ > 0 ? idle_rpm + throttle_ * (full_rpm - idle_rpm) : 0;
  rpm_ += (wanted_rpm - rpm_) * std::min(1.0, seconds / rpm_lag);
  double load = 0;
  for (const double speed : speeds_) load = std::max(load, std::abs(speed));
  const double litres_an_hour =
      litres_an_hour_idle + (litres_an_hour_full - litres_an_hour_idle) * rpm_ / full_rpm;
  litres_ = std::max(0.0, litres_ - litres_an_hour * seconds / seconds_an_hour);
  const double oil_wanted =
      oil_at_rest + (oil_at_work - oil_at_rest) * rpm_ / full_rpm * (0.5 + load);
  oil_ += (oil_wanted - oil_) * seconds / oil_lag;
  pressure_ =
      has_pilot_pressure_ ? pressure_at_rest + (pressure_at_work - pressure_at_rest) * load : 0;
}

void Excavator::step_cylinder(HydraulicCylinder& cylinder, Movement movement, double seconds) {
  constexpr double speed_max = 40;  // degrees per second, in the middle of a stroke
  cylinder.step(wanted(movement), rpm_ / full_rpm, seconds);
  speeds_[index(movement)] = std::clamp(cylinder.speed() / speed_max, -1.0, 1.0);
}

void Excavator::step_turns(double seconds) {
  const double flow = rpm_ / full_rpm;
  for (const Movement movement :
       {Movement::slew, Movement::left_track, Movement::right_track, Movement::rotator}) {
    ValveSpool& spool = spools_[index(movement)];
    spool.step(wanted(movement), seconds);
    double& speed = speeds_[index(movement)];
    const double goal = spool.opening() * flow;
    if (movement == Movement::slew) {
      const double change = slew_acceleration / slew_max * seconds;
      speed += std::clamp(goal - speed, -change, change);
    } else {
      speed = goal;
    }
  }
  slew_ = std::remainder(slew_ + speed(Movement::slew) * slew_max * seconds, 360);
  rotator_ = std::remainder(rotator_ + speed(Movement::rotator) * rotator_max * seconds, 360);
  const double track_speed = is_fast_ ? fast_track_max : track_max;
  const double left = speed(Movement::left_track) * track_speed * seconds;
  const double right = speed(Movement::right_track) * track_speed * seconds;
  tracks_[0] += left;
  tracks_[1] += right;
  driven_ += std::abs(left + right) / 2;
  if (driven_ < way_to_new_place) return;
  driven_ = 0;
  left_here_ = earth_of_place;
}

bool Excavator::is_over_heap() const {
  return std::abs(std::remainder(slew_ - heap_at, 360)) <= heap_width;
}

void Excavator::step_earth(const Point& before, double seconds) {
  const Point now = tip();
  const double drawn = before.x - now.x;
  if (now.z < 0 && drawn > 0) {
    const double cut = std::min(-now.z, cut_max) * bucket_width * drawn;
    const double taken = std::min({cut, room_ - earth_.in_bucket, left_here_});
    earth_.dug += taken;
    earth_.in_bucket += taken;
    left_here_ -= taken;
  }
  const bool pours = now.z > 0 && bucket_.angle() > pours_above;
  if ((!pours && !has_hole_) || earth_.in_bucket <= 0) return;
  const double poured = std::min(earth_.in_bucket, pours_a_second * seconds);
  earth_.in_bucket -= poured;
  (is_over_heap() && !has_hole_ ? earth_.heaped : earth_.spilled) += poured;
  if (earth_.in_bucket <= 0) draw_fill();
}

/// Draws the fill of the next bucket.
void Excavator::draw_fill() {
  constexpr std::uint32_t steps = 1000;
  const double share = static_cast<double>(soil_.below(steps + 1)) / steps;
  room_ = bucket_capacity * (fill_least + share * (fill_most - fill_least));
}

}  // namespace canvoy
