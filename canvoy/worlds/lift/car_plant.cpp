#include "canvoy/worlds/lift/car_plant.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::lift {

using cia417::CarDriveHardware;
using cia417::CarPositionHardware;
using cia417::DriveReadings;
using cia417::MotionProfile;
using cia417::MotionState;
using cia417::PositionReadings;

namespace {

constexpr double gravity = 9.81;
/// Acceleration of a car by a motor without control.
constexpr double runaway_acceleration = 0.8;

constexpr double sign_of(double value) {
  return value < 0 ? -1 : 1;
}

}  // namespace

CarPlant::CarPlant(const CarPlantDesign& design, Callback<Time()> clock, double position_m)
    : design_(design), clock_(clock), state_{position_m, 0, 0} {}

CarDriveHardware CarPlant::drive_hardware() {
  return {.sense = callback<&CarPlant::sense_drive>(*this),
          .power = callback<&CarPlant::set_power>(*this),
          .release_brake = callback<&CarPlant::set_brake>(*this),
          .follow = callback<&CarPlant::follow>(*this),
          .arrest = callback<&CarPlant::arrest>(*this),
          .brake_holds = callback<&CarPlant::test_brake>(*this)};
}

CarPositionHardware CarPlant::position_hardware() {
  return {.sense = callback<&CarPlant::sense_position>(*this)};
}

// Events.

void CarPlant::lead_by(Callback<MotionState()> car) {
  settle();
  elsewhere_ = car;
  brake_released_ = true;
  state_ = elsewhere_();
  choose_motion();
}

void CarPlant::set_load(double kg) {
  settle();
  load_kg_ = kg;
  choose_motion();
}

void CarPlant::set_faults(const CarPlantFaults& faults) {
  settle();
  if (faults.drive_encoder_is_dead && !faults_.drive_encoder_is_dead) {
    frozen_drive_m_ = state_.position - profile_origin_m_;
  }
  if (faults.position_encoder_is_dead && !faults_.position_encoder_is_dead) {
    frozen_position_m_ = state_.position;
  }
  faults_ = faults;
  choose_motion();
}

void CarPlant::crank(double metre_per_second) {
  settle();
  crank_m_s_ = metre_per_second;
  state_.velocity = metre_per_second;
  choose_motion();
}

void CarPlant::release_gear() {
  settle();
  gear_is_caught_ = false;
  choose_motion();
}

void CarPlant::cut(bool is_cut) {
  if (is_cut == is_cut_) return;
  settle();
  is_cut_ = is_cut;
  choose_motion();
}

bool CarPlant::would_drift() const {
  const bool is_held = (!brake_released_ || is_cut_) && !gear_is_caught_;
  return is_held && std::abs(imbalance_n(state_.position)) > design_.friction_n;
}

void CarPlant::set_power(bool on) {
  settle();
  has_power_ = on;
  choose_motion();
}

void CarPlant::set_brake(bool released) {
  settle();
  brake_released_ = released;
  choose_motion();
}

bool CarPlant::brake_slips() const {
  const double force = design_.brake_force_n * faults_.brake_share + design_.friction_n;
  return !elsewhere_ && force < design_.brake_test_n;
}

/// By the motor, against the closed brake: it takes no time here.
bool CarPlant::test_brake() {
  if (!design_.has_brake_test || !brake_slips()) return true;
  brake_has_slipped_ = true;
  changed_();
  return false;
}

void CarPlant::follow(const MotionProfile& profile, Duration delay) {
  settle();
  profile_ = profile;
  profile_start_ = settled_at_ + delay;
  choose_motion();
}

void CarPlant::arrest() {
  settle();
  gear_is_caught_ = true;
  choose_motion();
}

// Motion.

/// True if the motor moves the car, and has its position.
bool CarPlant::is_led() const {
  return has_power_ && brake_released_ && !is_cut_ && !faults_.brake_is_stuck && !gear_is_caught_ &&
         !faults_.motor_runs_away && !faults_.drive_encoder_is_dead;
}

void CarPlant::choose_motion() {
  const Motion before = kind_;
  const double before_acceleration = acceleration_;
  if (crank_m_s_ != 0) {
    kind_ = Motion::free;
    acceleration_ = 0;
    stops_ = false;
  } else if (is_led() || elsewhere_) {
    kind_ = Motion::following;
  } else {
    run_free();
  }
  if (kind_ != before || acceleration_ != before_acceleration) changed_();
}

/// Motion by the forces on the car: constant from here on.
void CarPlant::run_free() {
  const bool brakes = !brake_released_ || is_cut_ || faults_.brake_is_stuck;
  const double pull = -imbalance_n(state_.position);
  double hold = design_.friction_n + (brakes ? design_.brake_force_n * faults_.brake_share : 0);
  const double mass = mass_kg();
  if (gear_is_caught_)
    hold = std::max(hold, mass * design_.gear_deceleration_m_s2 + std::abs(pull));
  const bool is_driven = has_power_ && !brakes && !gear_is_caught_;
  const bool moves = state_.velocity != 0;
  kind_ = Motion::free;
  stops_ = hold >= std::abs(pull);
  if (is_driven) {
    stops_ = false;
    acceleration_ = sign_of(moves ? state_.velocity : pull) * runaway_acceleration;
  } else if (moves) {
    acceleration_ = (pull - sign_of(state_.velocity) * hold) / mass;
    // Against its pull it comes to rest first; then its motion is determined again.
    stops_ = stops_ || state_.velocity * pull < 0;
  } else if (stops_) {
    kind_ = Motion::standing;
    acceleration_ = 0;
  } else {
    acceleration_ = (pull - sign_of(pull) * hold) / mass;
  }
}

/// State at `time`, in metres.
MotionState CarPlant::motion(Time time) const {
  if (elsewhere_) return elsewhere_();
  const double t = in_seconds(time - settled_at_);
  if (kind_ == Motion::standing) return {state_.position, 0, 0};
  if (kind_ == Motion::following) {
    const MotionState at = profile_.at(in_seconds(time - profile_start_));
    const double scale = 1 / design_.increments_per_m;
    const double slips = 1 - faults_.slip;
    const MotionState from = profile_.at(in_seconds(settled_at_ - profile_start_));
    return {state_.position + (at.position - from.position) * scale * slips,
            at.velocity * scale * slips, at.acceleration * scale * slips};
  }
  const bool slows = state_.velocity * acceleration_ < 0;
  const double until = slows && stops_ ? -state_.velocity / acceleration_ : t;
  const double part = std::min(t, until);
  const double position = state_.position + part * (state_.velocity + part * acceleration_ / 2);
  if (part < t) return {position, 0, 0};
  return {position, state_.velocity + part * acceleration_, acceleration_};
}

/// Updates the state to the present: a real clock is read once.
void CarPlant::settle() {
  const Time time = now();
  const MotionState at = motion(time);
  sums_ = sums_at(time, at);
  if (kind_ == Motion::following) {
    // The encoder measures the way of the motor; the ropes have slipped by a part of it.
    const double slips = faults_.slip / (1 - faults_.slip);
    profile_origin_m_ -= (at.position - state_.position) * slips;
  }
  const bool has_stopped = kind_ == Motion::free && at.velocity == 0 && state_.velocity != 0;
  state_ = at;
  settled_at_ = time;
  strike_buffers();
  if (has_stopped) choose_motion();
}

void CarPlant::strike_buffers() {
  const double low = -design_.overtravel_m;
  const double high = design_.travel_m + design_.overtravel_m;
  if (state_.position >= low && state_.position <= high) return;
  if (state_.velocity != 0) ++buffer_strikes_;
  state_ = {std::clamp(state_.position, low, high), 0, 0};
  kind_ = Motion::standing;
  acceleration_ = 0;
}

/// With the energy that the motor gives or takes from the settled state to `at`: kinetic, potential
/// and lost to friction.
CarPlant::Sums CarPlant::sums_at(Time time, const MotionState& at) const {
  Sums sums = sums_;
  sums.energy_in_joule += design_.standby_w * in_seconds(time - settled_at_);
  const double way = std::abs(at.position - state_.position);
  sums.way_m += way;
  if (kind_ != Motion::following) return sums;
  const double kinetic =
      mass_kg() / 2 * (at.velocity * at.velocity - state_.velocity * state_.velocity);
  const double potential = potential_joule(at.position) - potential_joule(state_.position);
  const double work = kinetic + potential + design_.friction_n * way;
  if (work >= 0) {
    sums.energy_in_joule += work / design_.motor_efficiency;
  } else {
    sums.energy_out_joule -= work * design_.regeneration_efficiency;
  }
  return sums;
}

double CarPlant::mass_kg() const {
  return design_.car_kg + load_kg_ + design_.counterweight_kg + design_.rotating_kg +
         design_.rope_kg_per_m * design_.travel_m;
}

/// Weight of the car's side minus that of the other one; ropes change sides with the car.
double CarPlant::imbalance_n(double position) const {
  const double ropes = design_.rope_kg_per_m * (design_.travel_m - 2 * position);
  return gravity * (design_.car_kg + load_kg_ - design_.counterweight_kg + ropes);
}

double CarPlant::potential_joule(double position) const {
  const double ropes = design_.rope_kg_per_m * position * (design_.travel_m - position);
  const double masses = design_.car_kg + load_kg_ - design_.counterweight_kg;
  return gravity * (masses * position + ropes);
}

// Visible state.

DriveReadings CarPlant::sense_drive() {
  settle();
  DriveReadings readings;
  const bool is_dead = faults_.drive_encoder_is_dead;
  const double position = is_dead ? frozen_drive_m_ : state_.position - profile_origin_m_;
  readings.position = position * design_.increments_per_m;
  readings.velocity = is_dead ? 0 : state_.velocity * design_.increments_per_m;
  readings.sensor_velocity = readings.velocity;
  readings.voltage = !is_cut_;
  readings.fault = faults_.drive_fault;
  if (state_.position <= design_.home_switch_m) {
    readings.home_position = (design_.home_switch_m - profile_origin_m_) * design_.increments_per_m;
  }
  return readings;
}

PositionReadings CarPlant::sense_position(unsigned) {
  settle();
  const bool is_dead = faults_.position_encoder_is_dead;
  PositionReadings readings;
  readings.position_millimetre =
      (is_dead ? frozen_position_m_ : state_.position - stretch_m()) * 1000;
  if (!is_dead) {
    readings.velocity_millimetre_per_second = state_.velocity * 1000;
    readings.acceleration_millimetre_per_second_squared = state_.acceleration * 1000;
  }
  readings.alarms = faults_.position_encoder_alarms ? 1 : 0;
  return readings;
}

CarPlant::Truth CarPlant::truth() {
  settle();
  return truth_of(state_, sums_);
}

CarPlant::Truth CarPlant::look() const {
  const Time time = now();
  const MotionState at = motion(time);
  return truth_of(at, sums_at(time, at));
}

CarPlant::Truth CarPlant::truth_of(const MotionState& at, const Sums& sums) const {
  return {
      .position_m = at.position - stretch_m(),
      .velocity_m_s = at.velocity,
      .acceleration_m_s2 = at.acceleration,
      .brake_is_closed = (!brake_released_ || is_cut_ || faults_.brake_is_stuck) && crank_m_s_ == 0,
      .is_cut = is_cut_ && !elsewhere_,
      .is_cranked = crank_m_s_ != 0,
      .gear_is_caught = gear_is_caught_,
      .brake_slips = brake_slips(),
      .buffer_strikes = buffer_strikes_,
      .energy_in_joule = sums.energy_in_joule,
      .energy_out_joule = sums.energy_out_joule,
      .way_m = sums.way_m};
}

}  // namespace canvoy::lift
