// What a car drive unit measures, tells and supervises while time goes on.
#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"

namespace canvoy::cia417 {

using cia402::DriveMode;

namespace {

/// So long after its end a stop for a fault has had its chance; then the brake does it.
constexpr Duration stop_time_reserve = 500ms;

/// In units of the drive: what an encoder that stands may change in one period.
constexpr double jump_distance = 5;

/// Of the travel: ends lie a little beyond software limits, and a search turns with a ramp.
constexpr double homing_way_max = 1.1;

/// Whether `since` began so long ago.
constexpr bool lasts(Time since, Duration time, Time now) {
  return since != never && now - since >= time;
}

}  // namespace

void CarDriveUnit::tick(Time now) {
  measure(now);
  supervise(now);
  if (is_stopping_) {
    finish_stop(now);
  } else if (state_ == DriveState::operation_enabled) {
    advance_mode(now);
  } else if (state_ == DriveState::ready_to_switch_on || state_ == DriveState::switched_on) {
    obey_level();
  }
  refresh_status();
  arm(now);
}

void CarDriveUnit::measure(Time now) {
  const DriveReadings before = std::exchange(readings_, hardware_.sense());
  const double past = std::chrono::duration<double>(now - measured_at_).count();
  measured_at_ = now;
  // An encoder that comes back tells another position at once: nothing has moved.
  const double change = readings_.position - before.position;
  const double jitter = jump_distance * std::abs(parameters_.units().position);
  const double speed_now = std::max(std::abs(readings_.velocity), std::abs(before.velocity));
  if (std::abs(change) > 2 * speed_now * past + jitter) stood_at_ += change;
  const DriveWindows& windows = parameters_.windows();
  const double speed = std::abs(readings_.velocity);
  if (speed > windows.velocity_threshold) {
    slow_since_ = never;
  } else if (slow_since_ == never) {
    slow_since_ = now;
  }
  is_slow_ = lasts(slow_since_, windows.velocity_threshold_time, now);
  const bool is_moved = brake_released_ && (!has_ended(now) || profile_.end().velocity != 0);
  is_standing_ = is_slow_ && !is_moved;
  if (is_standing_ && !has_stood_) stood_at_ = readings_.position;
  has_stood_ = !brake_released_ && (has_stood_ || is_standing_);
  const double aim = mode_ == DriveMode::profile_velocity ? velocity_goal_ : demand(now).velocity;
  if (std::abs(readings_.velocity - aim) > windows.velocity_window) {
    near_since_ = never;
  } else if (near_since_ == never) {
    near_since_ = now;
  }
  tell_velocities(now);
}

void CarDriveUnit::tell_velocities(Time now) {
  const DriveUnits& units = parameters_.units();
  const double wanted = has_power_ ? demand(now).velocity : 0;
  const bool by_sensor = sensor_selection_.is(cia402::SensorSelection::velocity_encoder);
  const double actual = by_sensor ? readings_.sensor_velocity : readings_.velocity;
  const auto in_units = [&](double velocity) { return std::llround(velocity / units.velocity); };
  velocity_demand_ = in_units(wanted);
  velocity_actual_ = in_units(actual);
  velocity_sensor_ = std::llround(readings_.sensor_velocity * units.sensor_velocity);
  control_effort_ = in_units(wanted);
  const auto& slippage = parameters_.windows().max_slippage;
  slips_ = slippage && has_power_ && std::abs(wanted - readings_.velocity) > *slippage;
}

void CarDriveUnit::supervise(Time now) {
  const double highest = parameters_.velocity_max() * settings_.overspeed_percent / 100;
  if (readings_.fault != 0) {
    hardware_code_ = (faults_ & hardware_fault) != 0 ? hardware_code_ : readings_.fault;
    fail(hardware_fault, error_of(hardware_fault));
  }
  if (highest > 0 && std::abs(readings_.velocity) > highest && (faults_ & overspeed) == 0) {
    hardware_.arrest();
    fail(overspeed, error_of(overspeed));
  }
  const double distance = settings_.unintended_distance * std::abs(parameters_.units().position);
  if (has_stood_ && std::abs(readings_.position - stood_at_) > distance &&
      (faults_ & unintended) == 0) {
    hardware_.arrest();
    fail(unintended, error_of(unintended));
  }
  watch_voltage();
  if (lags_behind(now)) {
    is_following_error_ = true;
    fail(following, error_of(following));
  }
}

/// Transitions 9, 12 and 14: as if the voltage were disabled.
void CarDriveUnit::watch_voltage() {
  if (readings_.voltage || !is_powered(state_)) return;
  const bool is_fault = state_ == DriveState::fault_reaction_active;
  enter(is_fault ? DriveState::fault : DriveState::switch_on_disabled);
}

bool CarDriveUnit::lags_behind(Time now) {
  const double window = settings_.following_window * std::abs(parameters_.units().position);
  const bool is_behind =
      brake_released_ && std::abs(demand(now).position - readings_.position) > window;
  if (!is_behind) {
    behind_since_ = never;
  } else if (behind_since_ == never) {
    behind_since_ = now;
  }
  return lasts(behind_since_, settings_.following_time, now);
}

void CarDriveUnit::finish_stop(Time now) {
  const bool gives_up = state_ == DriveState::fault_reaction_active &&
                        seconds_since(start_, now - stop_time_reserve) > profile_.duration();
  if (!is_standing_ && !gives_up) return;
  is_stopping_ = false;
  has_arrived_ = true;
  close_brake();
  if (!after_stop_) return;
  enter(*after_stop_);
  // What was commanded on the way, and could not be done yet.
  obey_level();
}

void CarDriveUnit::advance_mode(Time now) {
  if (is_halted_) {
    has_arrived_ = is_standing_;
    if (is_standing_) close_brake();
    return;
  }
  if (is_standing_ && mode_wanted_.value() && mode_wanted_.value() != mode_) take_mode();
  switch (mode_) {
    case DriveMode::profile_position:
      if (is_travelling_ && has_ended(now)) finish_travel();
      break;
    case DriveMode::profile_velocity:
      watch_position_limit(now);
      has_arrived_ = lasts(near_since_, parameters_.windows().velocity_window_time, now);
      if (is_standing_ && velocity_goal_ == 0) close_brake();
      break;
    case DriveMode::homing:
      watch_homing(now);
      break;
    default:
      break;
  }
}

void CarDriveUnit::finish_travel() {
  if (next_.is_waiting) {
    next_.is_waiting = false;
    return travel(next_.position, 0);
  }
  const double window = settings_.position_window * std::abs(parameters_.units().position);
  if (!is_standing_ || std::abs(readings_.position - target_) > window) return;
  is_travelling_ = false;
  has_arrived_ = true;
  close_brake();
}

/// In profile velocity mode the car stops before it leaves the range of positions.
void CarDriveUnit::watch_position_limit(Time now) {
  const MotionState at = demand(now);
  if (at.velocity == 0 || velocity_goal_ == 0) return;
  const double limit =
      home_ + (at.velocity > 0 ? parameters_.position_max() : parameters_.position_min());
  const MotionLimits& ramps = parameters_.ramps();
  const double seconds = std::chrono::duration<double>(settings_.control_period).count();
  const double way = std::abs(MotionProfile::stopping_distance(at, ramps)) +
                     2 * seconds * (std::abs(at.velocity) + ramps.acceleration * seconds);
  if (way < std::abs(limit - at.position)) return;
  is_limited_ = true;
  velocity_goal_ = 0;
  if (MotionProfile::can_reach(at, limit, ramps)) {
    follow(MotionProfile::to_position(at, limit, ramps));
  } else {
    slow_down(StopReaction::quick_stop_ramp);
  }
}

void CarDriveUnit::watch_homing(Time now) {
  if (homing_ == Homing::searching) {
    const int direction = search_.direction();
    found_ = search_.look(readings_);
    homing_failed_ = !found_ && has_missed_home(now);
    if (!found_ && !homing_failed_) {
      if (search_.direction() != direction) seek_home();
      return;
    }
    homing_ = Homing::stopping;
    slow_down(StopReaction::slow_down_ramp);
  }
  if (is_standing_ && homing_ == Homing::stopping) end_homing();
  if (is_standing_ && homing_ == Homing::idle) close_brake();
}

bool CarDriveUnit::has_missed_home(Time now) const {
  if (!search_.is_possible(readings_) || search_.is_at_end(readings_)) return true;
  const double way = std::abs(readings_.position - homing_from_) / homing_way_max;
  if (settings_.travel > 0) {
    return way > settings_.travel * std::abs(parameters_.units().position);
  }
  return way > parameters_.position_max() - parameters_.position_min() ||
         now - homing_since_ > settings_.homing_time_max;
}

std::uint16_t CarDriveUnit::mode_bits() const {
  const auto bits = [](bool bit_12, bool bit_13) {
    return static_cast<std::uint16_t>((bit_12 ? 0x1000 : 0) | (bit_13 ? 0x2000 : 0));
  };
  switch (mode_) {
    case DriveMode::profile_velocity:
      return bits(is_slow_, slips_);
    case DriveMode::homing:
      return bits(has_homed_, homing_failed_);
    default:
      return bits(is_acknowledged_, is_following_error_);
  }
}

void CarDriveUnit::refresh_status() {
  unsigned word = state_bits(state_) | mode_bits();
  if (readings_.voltage) word |= status_bit::voltage_enabled;
  if (readings_.warning) word |= status_bit::warning;
  if (node_.state() == NmtState::operational) word |= status_bit::remote;
  if (has_arrived_) word |= status_bit::target_reached;
  if (is_limited_) word |= status_bit::internal_limit;
  statusword_ = word;
}

/// Again when the profile ends; else often while the car moves, and seldom while it stands.
void CarDriveUnit::arm(Time now) {
  const bool is_busy = brake_released_ || !is_standing_;
  Time next = now + (is_busy ? settings_.control_period : settings_.standing_period);
  if (brake_released_ && !has_ended(now)) {
    const double seconds = profile_.duration() - seconds_since(start_, now);
    const auto left = std::min(seconds, 1e6) * 1e6;
    next = std::min(next, now + Duration(std::llround(std::ceil(left))));
  }
  if (timer_.at() > next) node_.timers().arm(timer_, std::max(next, now + 1us));
}

}  // namespace canvoy::cia417
