#include "canvoy/sim/lift/shaft_car.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace canvoy::lift {

namespace {

using cia417::MotionProfile;
using cia417::MotionState;

constexpr double gravity = 9.81;
constexpr double brake_deceleration_m_s2 = 2.5;
constexpr double standing_m_s = 0.0005;
/// Of guide shoes and ropes, and of motor and inverter.
constexpr double friction_n = 250;
constexpr double efficiency = 0.85;

}  // namespace

ShaftCar::ShaftCar(const LiftDesign& design, std::function<Time()> clock,
                   std::function<void()> changed)
    : design_(design), clock_(std::move(clock)), changed_(std::move(changed)) {}

cia417::CarDriveHardware ShaftCar::hardware() {
  return {.sense = Callback<cia417::DriveReadings()>::to<&ShaftCar::sense>(*this),
          .power = Callback<void(bool)>::to<&ShaftCar::switch_power>(*this),
          .release_brake = Callback<void(bool)>::to<&ShaftCar::release_brake>(*this),
          .follow = Callback<void(const MotionProfile&, Time)>::to<&ShaftCar::follow>(*this)};
}

double ShaftCar::seconds_since(Time start, Time now) const {
  return std::max(std::chrono::duration<double>(now - start).count(), 0.0);
}

void ShaftCar::place(double position_m) {
  profile_ = MotionProfile::resting_at(position_m * increments_per_m);
  accounted_position_m_ = position_m;
}

MotionState ShaftCar::at(Time now) const {
  const MotionState raw = profile_.at(seconds_since(start_, now));
  return {raw.position / increments_per_m, raw.velocity / increments_per_m,
          raw.acceleration / increments_per_m};
}

bool ShaftCar::is_moving(Time now) const {
  return std::abs(at(now).velocity) > standing_m_s ||
         seconds_since(start_, now) < profile_.duration();
}

bool ShaftCar::is_braking(Time now) const {
  return is_braked_ && seconds_since(start_, now) < profile_.duration();
}

cia417::DriveReadings ShaftCar::sense() {
  const MotionState raw = profile_.at(seconds_since(start_, clock_()));
  return {.position = raw.position, .velocity = raw.velocity, .sensor_velocity = raw.velocity};
}

void ShaftCar::switch_power(bool on) {
  has_power_ = on;
  if (!on) brake();
}

void ShaftCar::release_brake(bool released) {
  is_released_ = released;
  if (!released) brake();
}

/// A car that moves is slowed down by it; one that stands stays.
void ShaftCar::brake() {
  const Time now = clock_();
  account(now);
  const MotionState raw = profile_.at(seconds_since(start_, now));
  cia417::MotionLimits limits{.velocity = design_.speed_m_s * 2 * increments_per_m,
                              .acceleration = brake_deceleration_m_s2 * increments_per_m,
                              .deceleration = brake_deceleration_m_s2 * increments_per_m};
  limits.type = cia402::ProfileType::linear;
  is_braked_ = std::abs(raw.velocity) > standing_m_s * increments_per_m;
  profile_ = is_braked_ ? MotionProfile::to_velocity({raw.position, raw.velocity, 0}, 0, limits)
                        : MotionProfile::resting_at(raw.position);
  start_ = now;
  changed_();
}

void ShaftCar::follow(const MotionProfile& profile, Time start) {
  if (!has_power_ || !is_released_) return;
  account(clock_());
  profile_ = profile;
  start_ = start;
  is_braked_ = false;
  changed_();
}

/// Work against the imbalance of car and counterweight, against inertia and friction; what is won
/// in braking is not fed back.
void ShaftCar::account(Time now) {
  const double passed_s = seconds_since(accounted_at_, now);
  accounted_at_ = now;
  const MotionState state = at(now);
  const double way_m = state.position - accounted_position_m_;
  accounted_position_m_ = state.position;
  distance_m_ += std::abs(way_m);
  if (passed_s <= 0 || is_braked_) return;
  const CarDesign& car = design_.car;
  const double counterweight_kg = car.mass_kg + design_.balance * car.rated_load_kg;
  const double moved_kg = car.mass_kg + load_kg_ + counterweight_kg;
  const double imbalance_kg = car.mass_kg + load_kg_ - counterweight_kg;
  const double force_n =
      imbalance_kg * gravity + moved_kg * state.acceleration + std::copysign(friction_n, way_m);
  energy_j_ += std::max(force_n * way_m, 0.0) / efficiency;
}

}  // namespace canvoy::lift
