#include "canvoy/worlds/lift/door_plant.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/worlds/lift/norm_bounds.hpp"

namespace canvoy::lift {

namespace {

using cia417::Detection;
using cia417::DoorDrive;
using cia417::DoorReadings;
using cia417::DoorState;

/// Within this distance of an end, it is at the end.
constexpr double end_m = 1e-6;
/// Shares of the time of a whole way in which it accelerates, and in which it decelerates.
constexpr double ramp = 0.2;

Detection detection(bool is_seen, bool is_broken) {
  if (is_broken) return Detection::error;
  return is_seen ? Detection::yes : Detection::no;
}

}  // namespace

DoorPlant::DoorPlant(const DoorPlantOptions& options) : options_(options) {
  motion_.rest(Time{}, 0);
}

cia417::DoorHardware DoorPlant::hardware() {
  return {.sense = callback<&DoorPlant::sense>(*this),
          .drive = callback<&DoorPlant::drive>(*this),
          .lock = callback<&DoorPlant::lock>(*this),
          .use_battery = callback<&DoorPlant::use_battery>(*this),
          .next_change = callback<&DoorPlant::next_change_for_device>(*this)};
}

cia417::LightBarrierHardware DoorPlant::light_barrier_hardware() {
  return {.sense = callback<&DoorPlant::beam_of>(*this)};
}

Detection DoorPlant::beam() const {
  return detection(obstacle_.has_value() || faults_.barrier_is_covered, faults_.barrier_is_broken);
}

// Actions of people and faults.

void DoorPlant::stand_in_way(Time now, bool is_in_way, const DoorObstacle& obstacle) {
  settle(now);
  if (is_in_way) {
    obstacle_ = obstacle;
    // An obstacle is not wider than the gap.
    obstacle_->width_m = std::min(obstacle.width_m, motion_.position_m(now));
  } else {
    obstacle_.reset();
  }
  move(now);
  changed_();
}

void DoorPlant::approach(bool is_near) {
  is_near_ = is_near;
  changed_();
}

void DoorPlant::touch_edge(bool is_touched) {
  edge_is_touched_ = is_touched;
  changed_();
}

void DoorPlant::set_faults(Time now, const DoorFaults& faults) {
  if (faults == faults_) return;
  settle(now);
  const bool lock_was_stuck = faults_.lock_is_stuck;
  faults_ = faults;
  if (lock_was_stuck != faults.lock_is_stuck) lock(lock_wanted_, now);
  move(now);
  changed_();
}

// The hardware.

DoorReadings DoorPlant::sense(Time now) {
  settle(now);
  asked_at_ = now;
  const double position = open_m(now);
  check_invariant(position >= -end_m && position <= width_m() + end_m);
  return {.is_closed = position <= end_m,
          .is_open = position >= width_m() - end_m,
          .has_fault = faults_.drive_fails,
          .position_mm = static_cast<std::uint16_t>(std::lround(position * 1000)),
          .force_limit = detection(is_pushing(now) && order_.limits_force, false),
          .motion = detection(is_near_, faults_.motion_detector_is_broken),
          .finger = detection(edge_is_touched_, faults_.finger_protector_is_broken),
          .lock = detection(is_locked(now), false),
          .safety_contact = detection(contact_is_closed(now), false),
          .battery = detection(uses_battery_, false),
          .light_barrier = options_.has_light_barrier ? beam() : Detection::not_available};
}

void DoorPlant::drive(const DoorDrive& order, Time now) {
  settle(now);
  order_ = order;
  move(now);
}

void DoorPlant::lock(bool locks, Time now) {
  if (is_led_) return;
  was_locked_ = is_locked(now);
  lock_wanted_ = locks;
  lock_at_ = faults_.lock_is_stuck ? never : now + options_.lock_time;
}

void DoorPlant::lead(Time now, const cia417::DoorReport& said,
                     std::optional<std::uint16_t> position_mm) {
  settle(now);
  is_led_ = true;
  met_at_ = lock_at_ = never;
  const bool has_lock = said.lock != Detection::not_available;
  was_locked_ = is_closed(said.state) && (!has_lock || said.lock == Detection::yes);
  std::optional<double> position_m;
  if (position_mm) position_m = std::min(*position_mm / 1000.0, options_.width_m);
  move_as_said(now, said.state, position_m);
}

/// An end is where the door reports it, however wide it opens.
void DoorPlant::move_as_said(Time now, DoorState state, std::optional<double> position_m) {
  const bool opens = state == DoorState::opening || state == DoorState::re_opening;
  led_speed_m_s_ = 0;
  if (cia417::is_closed(state)) return motion_.rest(now, 0);
  if (cia417::is_open(state)) return motion_.rest(now, options_.width_m);
  order_ = {.motion = opens ? DoorDrive::Motion::open : DoorDrive::Motion::close};
  if (cia417::is_moving(state)) led_speed_m_s_ = opens ? way().speed_m_s : -way().speed_m_s;
  if (position_m) return motion_.rest(now, *position_m);
  if (cia417::is_moving(state)) return motion_.go(now, way());
  motion_.rest(now, open_m(now));
}

// Motion.

double DoorPlant::width_m() const {
  const std::size_t profile =
      std::min<std::size_t>(order_.width_profile, options_.width_profiles.size() - 1);
  return options_.width_m * options_.width_profiles[profile];
}

DoorMotion::Way DoorPlant::way() const {
  const bool closes = order_.motion == DoorDrive::Motion::close;
  const double time_s = closes ? options_.close_time_s : options_.open_time_s;
  const std::size_t profile =
      std::min<std::size_t>(order_.velocity_profile, options_.velocity_profiles.size() - 1);
  const double speed = options_.width_m / (time_s * (1 - ramp));
  const double share =
      options_.velocity_profiles[profile] * (order_.is_reduced ? options_.reduced_share : 1.0);
  return {.target_m = closes ? 0 : width_m(),
          .speed_m_s = speed * share,
          .acceleration_m_s2 = speed / (time_s * ramp)};
}

/// The edge stands at the obstacle from the time when it met it.
void DoorPlant::settle(Time now) {
  if (now < met_at_ || !obstacle_) return;
  note_impact(motion_.speed_m_s(met_at_));
  motion_.rest(met_at_, obstacle_->width_m);
  met_at_ = never;
}

void DoorPlant::note_impact(double speed_m_s) {
  const double energy = door_energy_j(options_.mass_kg, speed_m_s);
  impact_energy_max_j_ = std::max(impact_energy_max_j_, energy);
}

/// Moves by its command, with the present people.
void DoorPlant::move(Time now) {
  if (is_led_) return;
  met_at_ = never;
  if (faults_.is_stuck) return motion_.rest(now, motion_.position_m(now));
  const bool is_driven = order_.motion != DoorDrive::Motion::none && !faults_.belt_is_broken;
  if (!is_driven) {
    const bool brakes = order_.has_torque && !faults_.belt_is_broken;
    return run_out(now, brakes ? way().acceleration_m_s2 : options_.friction_m_s2);
  }
  if (order_.motion == DoorDrive::Motion::open && is_locked(now)) {
    return motion_.rest(now, motion_.position_m(now));
  }
  const double held_at = held_at_m();
  const bool is_held = held_at >= 0;
  const double speed = motion_.speed_m_s(now);
  if (is_held && motion_.position_m(now) <= held_at + end_m && speed <= 0) {
    note_impact(speed);
    return motion_.rest(now, motion_.position_m(now));
  }
  motion_.go(now, way());
  if (is_held) met_at_ = motion_.time_at(held_at, now);
}

/// Decelerates, and is stopped by the end of its way if it reaches it.
void DoorPlant::run_out(Time now, double deceleration_m_s2) {
  motion_.stop(now, deceleration_m_s2);
  const double rest = motion_.position_m(motion_.end());
  const double end = std::clamp(rest, 0.0, options_.width_m);
  if (rest != end) motion_.go(now, {.target_m = end, .acceleration_m_s2 = deceleration_m_s2});
}

/// Width at which an obstacle holds the closing door; below 0: there is none.
double DoorPlant::held_at_m() const {
  const double force = order_.limits_force ? options_.limited_force_n : options_.full_force_n;
  if (order_.motion != DoorDrive::Motion::close || !obstacle_) return -1;
  return force <= obstacle_->force_n ? obstacle_->width_m : -1;
}

// True state.

double DoorPlant::open_m(Time at) const {
  if (at >= met_at_ && obstacle_) return obstacle_->width_m;
  return std::clamp(motion_.position_m(at), 0.0, options_.width_m);
}

double DoorPlant::speed_m_s(Time at) const {
  if (is_led_) return led_speed_m_s_;
  return at >= met_at_ ? 0 : motion_.speed_m_s(at);
}

bool DoorPlant::is_locked(Time at) const {
  if (faults_.lock_is_open) return false;
  if (at < lock_at_) return was_locked_;
  return lock_wanted_ && open_m(at) <= end_m;
}

bool DoorPlant::contact_is_closed(Time at) const {
  return !faults_.contact_is_broken && open_m(at) <= options_.contact_at_m;
}

bool DoorPlant::is_pushing(Time at) const {
  const bool closes = order_.motion == DoorDrive::Motion::close && !faults_.belt_is_broken;
  return closes && obstacle_ && speed_m_s(at) == 0 && open_m(at) > end_m &&
         open_m(at) <= obstacle_->width_m + end_m;
}

Time DoorPlant::next_change(Time after) const {
  if (is_led_) return never;
  Time next = never;
  const auto add = [&next, after](Time at) {
    if (at > after) next = std::min(next, at);
  };
  add(lock_at_);
  if (met_at_ != never) add(met_at_);
  add(motion_.end());
  const Time contact = motion_.time_at(options_.contact_at_m, after);
  if (contact <= met_at_) add(contact);
  return next;
}

}  // namespace canvoy::lift
