#include "canvoy/worlds/bus_line/route_position.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "canvoy/worlds/bus_line/passed_stop.hpp"

namespace canvoy::bus_line {

namespace {

/// A device that boots may send an old journey for a moment.
constexpr Duration settled = 10s;
/// Longer than a braking bus needs for the last pulse.
constexpr Duration stands_after = 600ms;
/// Within this distance of the first stop, it is at the stop.
constexpr double near_first_stop_m = 15;
/// Where a journey ends this near to the start of the next one, there is no drive between them.
constexpr double no_transfer_m = 30;
/// A bus that may be elsewhere is on its route after positions have met it for this distance.
constexpr double certain_m = 100;
/// This many consecutive positions are not wrong.
constexpr unsigned doubts_max = 3;
/// Positions come each second: a bus that stands for this time has received one.
constexpr Duration has_stood = 2s;
/// With open doors, it is certain to be at a stop within this distance.
constexpr double doors_open_m = 40;
/// Uncertainty in m of the way from the last stop.
constexpr double past_stop_m = 2;
/// Effect of its speed by pulses, off by one pulse in ten samples, on the place where it has passed
/// a stop, in m for each m/s: 0.25 / gentle_braking.
constexpr double past_by_speed = 0.35;
constexpr std::size_t slow_looks = 4;
/// A stop that it left at once: one pulse from where it stood.
constexpr double left_stop_m = 0.15;
constexpr double touched_stop_m = 1;
/// At most one pulse in the last samples.
constexpr double slow_m = 0.2;
constexpr double leaving_m = 0.1;  // the first pulse

}  // namespace

void RoutePosition::begin(const BusRoute& route, Time now) {
  const bool was_told = route_ != nullptr;
  if (was_told && is_located_ && is_at_end()) {
    ended_at_ = base_odometer_ + metres_of(place_) - base_metres_;
  }
  has_just_begun_ = was_told && ended_at_.has_value();
  begun_at_ = std::exchange(ended_at_, std::nullopt).value_or(0);
  has_changed_ = was_told && is_standing_ && now - journey_since_ > settled;
  transfer_m_ = was_told ? metres_between(route_->path.at(metres_of(route_->stops.size() - 1)),
                                          route.path.at(route.stops.front().metres))
                         : 0;
  may_be_elsewhere_ = transfer_m_ > no_transfer_m;
  journey_since_ = now;
  route_ = &route;
  is_located_ = false;
  place_ = reached_ = 0;
  match_.forget();
  // It has not driven along this route since an older position.
  const bool is_new = fix_ && odometer_ - fix_->odometer < at_stop_m;
  if (is_new) match_.take(route.path, fix_->point, fix_->odometer);
}

void RoutePosition::lose_route() {
  route_ = nullptr;
  is_located_ = false;
  ended_at_.reset();
}

void RoutePosition::forget() {
  lose_route();
  fix_.reset();
}

void RoutePosition::take_fix(const std::optional<GeoPoint>& point) {
  fix_.reset();
  if (!point) return match_.forget();
  fix_ = Fix{*point, sensors_.odometer()};
  if (route_ == nullptr) return;
  if (!is_located_) return match_.take(route_->path, *point, fix_->odometer);
  doubt();
  if (is_located_ && !is_exact_) refine();
}

/// A position at another place. Several of them are right; so is one where a single position, which
/// may have waited on a disturbed bus, gave the place.
void RoutePosition::doubt() {
  const double known = base_metres_ + fix_->odometer - base_odometer_;
  const double off = metres_between(route_->path.at(known), fix_->point);
  if (off <= RouteMatch::off_route_m) {
    doubts_ = 0;
    is_confirmed_ = true;
  } else if (!is_confirmed_) {
    is_located_ = false;
    match_.take(route_->path, fix_->point, fix_->odometer);
  } else if (++doubts_ >= doubts_max) {
    get_lost();
  }
}

/// It drives outside of its route, or its place was wrong.
void RoutePosition::get_lost() {
  is_located_ = has_just_begun_ = has_changed_ = false;
  may_be_elsewhere_ = true;
  match_.forget();
}

void RoutePosition::sense(Time now) {
  const double odometer = sensors_.odometer();
  if (odometer != odometer_) moved_at_ = now;
  odometer_ = odometer;
  stands_for_ = now - moved_at_;
  is_standing_ = stands_for_ >= stands_after;
  const std::size_t look = looks_++ % pulses_.size();
  const std::size_t before = (look + pulses_.size() - slow_looks) % pulses_.size();
  is_slow_ = odometer_ - pulses_.at(before) < slow_m;
  const std::chrono::duration<double> looked = look_period * pulses_.size();
  speed_ = (odometer_ - pulses_.at(look)) / looked.count();
  pulses_.at(look) = odometer_;
}

/// The first position after the start of positioning may be a second old: the next ones are better.
void RoutePosition::refine() {
  const double known = base_metres_ + fix_->odometer - base_odometer_;
  std::optional<double> nearest;
  for (const double along : route_->path.places_near(fix_->point, RouteMatch::off_route_m)) {
    if (std::abs(along - known) > RouteMatch::off_route_m) continue;
    if (!nearest || std::abs(along - known) < std::abs(*nearest - known)) nearest = along;
  }
  if (!nearest) return;
  base_metres_ = *nearest;
  base_odometer_ = fix_->odometer;
}

bool RoutePosition::is_at_end() const {
  return is_last() && (is_at_stop_ || metres_of(place_) - metres() < near_first_stop_m);
}

void RoutePosition::set_place(double metres, double odometer) {
  base_metres_ = metres;
  base_odometer_ = odometer;
  is_at_stop_ = was_slow_ = is_exact_ = false;
  for (place_ = 0; !is_last() && metres_of(place_) < this->metres() - at_stop_m;) ++place_;
  reached_ = place_ == 0 ? 0 : place_ - 1;
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
  if (!is_located_) return false;
  is_confirmed_ = !fix_;
  has_just_begun_ = has_changed_ = may_be_elsewhere_ = false;
  doubts_ = 0;
  match_.forget();
  return true;
}

bool RoutePosition::find() {
  const bool is_near_start =
      fix_ && odometer_ - fix_->odometer <= near_first_stop_m &&
      metres_between(fix_->point, route_->path.at(metres_of(0))) < near_first_stop_m;
  if (is_near_start && find_first_stop()) return true;
  if (has_just_begun_) return find_start();
  // Near the first stop, where it may be arriving or leaving, it waits for the next positions.
  return !is_near_start && find_on_the_way();
}

/// A position from before it stood there is not part of this journey. A rolling bus is there only
/// where it comes from the end of another journey: otherwise it has left, by an unknown distance.
bool RoutePosition::find_first_stop() {
  const bool has_rolled = speed_ != 0 && !has_just_begun_;
  const bool has_position = odometer_ == fix_->odometer && !has_rolled;
  const bool is_here = has_position || (is_standing_ && !has_just_begun_);
  if (!is_here) return false;
  stand_at_first_stop(odometer_);
  is_exact_ = is_standing_ || !(has_just_begun_ && may_be_elsewhere_);
  return true;
}

/// From the end of the journey before.
bool RoutePosition::find_start() {
  return may_be_elsewhere_ ? find_end_of_transfer() : find_start_at_end();
}

/// Both are the same place: it stands there, or has left it.
bool RoutePosition::find_start_at_end() {
  const double driven = odometer_ - begun_at_;
  if (driven >= near_first_stop_m) {
    has_just_begun_ = driven < route_->path.metres();
    if (has_just_begun_) set_place(metres_of(0) + driven, odometer_);
    return has_just_begun_;
  }
  const bool is_there = is_standing_ && (!fix_ || stands_for_ >= has_stood);
  if (is_there) stand_at_first_stop(odometer_);
  return is_there;
}

/// Without a position at the first stop: it stands where the way there ends, or doors open. With
/// positions, it may have left the stop as well.
bool RoutePosition::find_end_of_transfer() {
  const double driven = odometer_ - begun_at_;
  const double beyond = driven - transfer_m_;
  const bool has_door_open = driven > near_first_stop_m && has_open_door();
  if (!fix_ && is_standing_ && (std::abs(beyond) < near_first_stop_m || has_door_open)) {
    stand_at_first_stop(odometer_);
    return true;
  }
  if (beyond < near_first_stop_m) return false;
  has_just_begun_ = fix_.has_value();
  return find_on_the_way();
}

bool RoutePosition::find_on_the_way() {
  if (!fix_ && has_changed_ && !may_be_elsewhere_) {
    // The driver logs in where a journey begins.
    stand_at_first_stop(odometer_);
    return true;
  }
  const auto along = match_.metres(odometer_, may_be_elsewhere_ ? certain_m : 0);
  if (along) set_place(*along, odometer_);
  return along.has_value();
}

void RoutePosition::follow() {
  const double left = odometer_ - base_odometer_;
  if (is_at_stop_ && !is_exact_) {
    // On its way to the first stop it still rolls.
    if (is_standing_) stand_at_first_stop(odometer_);
    if (is_standing_ || left < 2 * near_first_stop_m) return;
    is_exact_ = true;
  }
  if (is_at_stop_) {
    if (is_last() && left > past_stop_m) return leave_end();
    if (left < leaving_m || is_last()) return;
    is_at_stop_ = false;
    ++place_;
  }
  const double beyond = metres() - metres_of(place_);
  if (is_standing_ && std::abs(beyond) < (has_open_door() ? doors_open_m : at_stop_m)) {
    is_at_stop_ = is_exact_ = true;
    was_slow_ = false;
    base_metres_ = metres_of(place_);
    base_odometer_ = odometer_;
    reached_ = place_;
    return;
  }
  was_slow_ = was_slow_ || (is_slow_ && std::abs(beyond) < touched_stop_m);
  const double certain = beyond - std::min(past_stop_m, past_by_speed * speed_);
  const bool is_past = was_slow_ ? beyond >= left_stop_m : has_passed_stop(certain, speed_);
  if (is_standing_ || !is_past || is_last()) return;
  reached_ = place_;
  ++place_;
  was_slow_ = false;
}

/// Leaves the end on a journey that it has not received.
void RoutePosition::leave_end() {
  const double end = base_odometer_;
  get_lost();
  ended_at_ = end;
}

}  // namespace canvoy::bus_line
