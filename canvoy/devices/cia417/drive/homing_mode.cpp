#include "canvoy/devices/cia417/drive/homing_mode.hpp"

#include <cmath>

namespace canvoy::cia417 {

namespace {

/// Multiple of the travel: ends are a little beyond software limits, and a search turns with a
/// ramp.
constexpr double way_max = 1.1;

}  // namespace

void HomingMode::begin_anew() {
  give_up();
  has_homed_ = has_failed_ = false;
}

void HomingMode::start(bool is_halted, Time now) {
  has_homed_ = has_failed_ = false;
  found_.reset();
  step_ = Step::searching;
  since_ = now;
  if (is_halted) return;
  search_.begin(car_.readings(), parameters_.units().position > 0);
  seek(now);
}

void HomingMode::seek(Time now) {
  from_ = car_.readings().position;
  const double speed = settings_.velocity * std::abs(parameters_.units().velocity);
  car_.follow(MotionProfile::to_velocity(car_.present(now), search_.direction() * speed,
                                         parameters_.ramps()),
              now);
}

void HomingMode::cancel(Time now) {
  if (is_under_way()) slow_down(now);
  step_ = Step::idle;
}

void HomingMode::slow_down(Time now) {
  const double velocity = car_.present(now).velocity;
  car_.slow_down(parameters_.stop_ramp(cia402::StopReaction::slow_down_ramp, velocity), now);
}

std::optional<bool> HomingMode::look(Time now) {
  if (step_ == Step::searching && !search(now)) return std::nullopt;
  if (!car_.is_standing()) return std::nullopt;
  const bool has_ended = step_ == Step::stopping;
  if (has_ended) end();
  car_.close_brake();
  return has_ended ? std::optional(has_homed_) : std::nullopt;
}

/// True if the search has ended, with or without success.
bool HomingMode::search(Time now) {
  const int direction = search_.direction();
  found_ = search_.look(car_.readings());
  has_failed_ = !found_ && has_missed(now);
  if (!found_ && !has_failed_) {
    if (search_.direction() != direction) seek(now);
    return false;
  }
  step_ = Step::stopping;
  slow_down(now);
  return true;
}

bool HomingMode::has_missed(Time now) const {
  if (!search_.is_possible(car_.readings()) || search_.is_at_end(car_.readings())) return true;
  const double way = std::abs(car_.readings().position - from_) / way_max;
  if (settings_.travel > 0) return way > parameters_.increments(settings_.travel);
  return way > parameters_.position_max() - parameters_.position_min() ||
         now - since_ > settings_.time_max;
}

/// Position 0 is the home offset away from the home position.
void HomingMode::end() {
  step_ = Step::idle;
  has_homed_ = found_.has_value();
  if (!found_) return;
  const auto offset = static_cast<double>(parameters_.home_offset());
  parameters_.count_from(*found_, *found_ + offset * parameters_.units().position);
}

}  // namespace canvoy::cia417
