#include "canvoy/sim/bus/route_position.hpp"

#include <cmath>

namespace canvoy::bus {

namespace {

/// A device that boots may tell an old journey for a moment.
constexpr Duration settled = 10s;
/// Longer than who brakes takes for the last pulse.
constexpr Duration stands_after = 600ms;
/// So near to the first stop it is there.
constexpr double near_first_stop_m = 15;
/// Farther from its route it is on its way to the first stop.
constexpr double off_route_m = 60;
constexpr double at_stop_m = 3;
/// With open doors nobody doubts that it is at a stop.
constexpr double doors_open_m = 40;
/// Beyond a stop it has not stopped there.
constexpr double past_stop_m = 2;
/// Of a stop that it left at once: a pulse from where it stood.
constexpr double left_stop_m = 0.15;
constexpr double touched_stop_m = 1;
/// At most a pulse in the last looks.
constexpr double slow_m = 0.2;
constexpr double leaving_m = 0.1;  // the first pulse

}  // namespace

void RoutePosition::begin(const BusRoute& route, Time now) {
  has_just_begun_ = route_ != nullptr && is_located_ && is_at_end();
  has_changed_ = route_ != nullptr && is_standing_ && now - journey_since_ > settled;
  journey_since_ = now;
  route_ = &route;
  is_located_ = false;
  place_ = reached_ = 0;
}

void RoutePosition::lose_route() {
  route_ = nullptr;
  is_located_ = false;
}

void RoutePosition::forget() {
  lose_route();
  fix_.reset();
}

void RoutePosition::take_fix(const std::optional<GeoPoint>& point) {
  fix_.reset();
  if (!point) return;
  fix_ = Fix{*point, sensors_.odometer()};
  if (is_located_ && !is_exact_) refine();
}

void RoutePosition::sense(Time now) {
  const double odometer = sensors_.odometer();
  if (odometer != odometer_) moved_at_ = now;
  odometer_ = odometer;
  is_standing_ = now - moved_at_ >= stands_after;
  double& before = pulses_.at(looks_++ % pulses_.size());
  is_slow_ = odometer_ - before < slow_m;
  before = odometer_;
}

/// What positioning tells when it is started may be a second old: the next positions are better.
void RoutePosition::refine() {
  const double along = route_->path.nearest_to(fix_->point);
  const double known = base_metres_ + fix_->odometer - base_odometer_;
  if (std::abs(along - known) > off_route_m) return;
  base_metres_ = along;
  base_odometer_ = fix_->odometer;
}

bool RoutePosition::is_at_end() const {
  return is_last() && (is_at_stop_ || metres_of(place_) - metres() < near_first_stop_m);
}

void RoutePosition::stand_at_first_stop(double odometer) {
  place_ = reached_ = 0;
  is_at_stop_ = is_exact_ = true;
  base_metres_ = metres_of(0);
  base_odometer_ = odometer;
}

bool RoutePosition::locate() {
  if (route_ == nullptr || is_located_) return false;
  is_located_ = find();
  return is_located_;
}

bool RoutePosition::find() {
  if (!fix_) {
    // The driver logs in where a journey begins.
    if (has_changed_) stand_at_first_stop(odometer_);
    return has_changed_;
  }
  const Path& path = route_->path;
  if (metres_between(fix_->point, path.at(metres_of(0))) < near_first_stop_m) {
    return find_first_stop();
  }
  const double along = path.nearest_to(fix_->point);
  if (metres_between(path.at(along), fix_->point) > off_route_m || has_just_begun_) return false;
  base_metres_ = along;
  base_odometer_ = fix_->odometer;
  is_at_stop_ = was_slow_ = is_exact_ = false;
  for (place_ = 0; !is_last() && metres_of(place_) < metres() - at_stop_m;) ++place_;
  reached_ = place_ == 0 ? 0 : place_ - 1;
  return true;
}

/// A position from before it stood there is none of this journey.
bool RoutePosition::find_first_stop() {
  if (odometer_ - fix_->odometer > near_first_stop_m) return false;
  const bool is_old = odometer_ != fix_->odometer && has_just_begun_;
  if (!is_old) stand_at_first_stop(fix_->odometer);
  return !is_old;
}

void RoutePosition::follow() {
  if (is_at_stop_) {
    if (odometer_ - base_odometer_ < leaving_m || is_last()) return;
    is_at_stop_ = false;
    ++place_;
  }
  const double beyond = metres() - metres_of(place_);
  const bool has_open_door = is_standing_ && sensors_.has_open_door && sensors_.has_open_door();
  if (is_standing_ && std::abs(beyond) < (has_open_door ? doors_open_m : at_stop_m)) {
    is_at_stop_ = is_exact_ = true;
    was_slow_ = false;
    base_metres_ = metres_of(place_);
    base_odometer_ = odometer_;
    reached_ = place_;
    return;
  }
  was_slow_ = was_slow_ || (is_slow_ && std::abs(beyond) < touched_stop_m);
  if (is_standing_ || beyond < (was_slow_ ? left_stop_m : past_stop_m) || is_last()) return;
  reached_ = place_;
  ++place_;
  was_slow_ = false;
}

}  // namespace canvoy::bus
