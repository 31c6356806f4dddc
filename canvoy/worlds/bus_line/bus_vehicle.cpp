#include "canvoy/worlds/bus_line/bus_vehicle.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "canvoy/worlds/bus_line/passed_stop.hpp"

namespace canvoy::bus_line {

namespace {

constexpr Duration before_first_departure = 5min;
/// The driver opens the doors this long before a journey begins.
constexpr Duration opens_before = 3min;
constexpr Duration quiet_least = 2s;
constexpr Duration look_time = 1s;
/// Until this time, all passengers for the next stop have pressed the button; so none is carried
/// past the stop.
constexpr Duration pass_not_before = Riders::press_within + 2s;
constexpr double same_place_m = 30;
constexpr double transfer_speed = 8.3;
constexpr double slowest = 8.3;             ///< m/s: an early driver does not go slower
constexpr double fastest = 27.8;            ///< m/s: the law's limit for buses out of town
constexpr double slowest_in_traffic = 1.4;  ///< m/s: where a delay is given
constexpr double traffic_from = 0.85;       ///< least share of the speed, in traffic
constexpr double traffic_more = 0.15;       ///< that it may have beyond that
constexpr double mean_traffic = traffic_from + traffic_more / 2;
constexpr double lights_from = 0.3;  ///< shares of the way between two stops
constexpr double lights_to = 0.7;

double seconds(Duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Duration start_of(const Block& block, const BusOptions& options) {
  const Duration first = block.journeys.front().passings.front().departure;
  return options.start == Duration::min() ? first - before_first_departure : options.start;
}

BusVehicle::BusVehicle(const BusLine& line, std::size_t block, const BusOptions& options,
                       RiderHands hands)
    : line_(&line),
      block_(&line.blocks[block]),
      options_(options),
      random_(options.seed ^ (block + 1) * 0x9E37'79B9'7F4A'7C15),
      doors_(options.doors.size()),
      seen_(options.doors.size(), DoorState::closed),
      has_thing_(options.doors.size()),
      riders_(options.riders, random_.next(), options.doors, with_button(std::move(hands))) {
  zero_ = Time(-start_of(*block_, options));
  begin_journey(Time{});
}

/// Hands with the rider's button, which stops the bus unless a device of the world does.
RiderHands BusVehicle::with_button(RiderHands hands) {
  if (!hands.press_stop) {
    hands.press_stop = [this](Time now, const Rider&) {
      request_stop(now);
      return true;
    };
  }
  return hands;
}

void BusVehicle::tell(Time now, BusEvent event, std::size_t stop) const {
  if (told_) told_(now, event, stop);
}

void BusVehicle::request_stop(Time now) {
  if (stop_requested_ || state_ != BusState::driving) return;
  stop_requested_ = true;
  tell(now, BusEvent::stop_requested, place_);
}

void BusVehicle::break_door(Time now, std::size_t door, bool is_broken) {
  doors_[door].break_down(now, is_broken);
}

BusTruth BusVehicle::truth() const {
  return {.block = block_,
          .journey = &journey(),
          .route = &route(),
          .place = place_,
          .stop = &line_->stop(journey().route, place_),
          .is_at_stop = state_ == BusState::at_stop || state_ == BusState::over,
          .stop_requested = stop_requested_,
          .fare = fare_,
          .aboard = riders_.aboard()};
}

void BusVehicle::begin_journey(Time now) {
  place_ = 0;
  wants_to_go_ = false;
  riders_.begin_journey(now, journey(), route(), zero_);
  tell(now, BusEvent::journey_begins, 0);
  const GeoPoint start = route().path.at(route().stops.front().metres);
  if (journey_ > 0 && metres_between(position(), start) > same_place_m) {
    transfer_ = Path({position(), start});
    drive_.begin(transfer_);
    drive_.go(transfer_.metres(), transfer_speed);
    state_ = BusState::transferring;
    last_ = now;
    return;
  }
  end_transfer(now);
}

/// The bus stands at the first stop of the journey.
void BusVehicle::end_transfer(Time now) {
  drive_.begin(route().path, route().stops.front().metres);
  arrive(now);
}

void BusVehicle::arrive(Time now) {
  state_ = BusState::at_stop;
  stop_requested_ = false;
  wants_to_go_ = false;
  quiet_since_ = never;
  next_look_ = now;
  delay_ = now - (zero_ + passing().arrival);
  if (place_ == 0) delay_ = std::max(delay_, Duration{});
  fare_.reach(route().stops[place_].fare_zone, route().stops[place_].route_segment);
  riders_.stand_at(now, place_);
  tell(now, BusEvent::arrives, place_);
}

bool BusVehicle::are_closed() const {
  return std::all_of(doors_.begin(), doors_.end(),
                     [](const BusDoor& door) { return door.is_closed(); });
}

bool BusVehicle::wants_doors(Time now) const {
  if (place_ == 0 && now < departure() - opens_before) return riders_.aboard() > 0;
  if (options_.has_unkind_driver && !is_last_stop()) return riders_.wanting_out_at(place_) > 0;
  return riders_.wanting_out_at(place_) > 0 || riders_.waiting_at(place_, now) > 0 ||
         (is_last_stop() && riders_.aboard() > 0);
}

/// Actions of the driver at a stop, in steps of a second.
void BusVehicle::stand(Time now) {
  next_look_ = now + look_time;
  if (wants_to_go_) {
    if (are_closed()) return is_last_stop() ? end_journey(now) : leave(now);
    for (BusDoor& door : doors_) door.close(now);
    return;
  }
  const bool has_open = std::any_of(doors_.begin(), doors_.end(),
                                    [](const BusDoor& door) { return !door.is_closed(); });
  const bool can_open = std::any_of(doors_.begin(), doors_.end(),
                                    [](const BusDoor& door) { return !door.is_broken(); });
  if (!has_open && can_open && wants_doors(now)) {
    for (BusDoor& door : doors_) door.open(now);
    return;
  }
  stand_open(now);
}

/// The driver leaves when no passenger is at the doors, and the time has come.
void BusVehicle::stand_open(Time now) {
  const bool are_moving = std::any_of(doors_.begin(), doors_.end(),
                                      [](const BusDoor& door) { return door.deadline() != never; });
  if (are_moving || !riders_.is_quiet(now)) {
    quiet_since_ = never;
    return;
  }
  quiet_since_ = std::min(quiet_since_, now);
  const bool waits_here = place_ == 0 || !options_.has_hasty_driver;
  const bool must_wait =
      (waits_here && !is_last_stop() && passing().is_timing_point && now < departure()) ||
      (options_.late > Duration{} && is_to_come(now));
  if (must_wait || (!are_closed() && now < quiet_since_ + quiet_least)) return;
  wants_to_go_ = true;
  for (BusDoor& door : doors_) door.close(now);
  if (are_closed()) next_look_ = now;
}

void BusVehicle::end_journey(Time now) {
  if (journey_ + 1 < block_->journeys.size()) {
    riders_.leave(now, place_);
    ++journey_;
    return begin_journey(now);
  }
  state_ = BusState::over;
  tell(now, BusEvent::block_ends, place_);
}

void BusVehicle::leave(Time now) {
  delay_ = now - departure();
  riders_.leave(now, place_);
  tell(now, BusEvent::leaves, place_);
  ++place_;
  state_ = BusState::driving;
  last_ = now;
  begin_leg(now);
}

/// Speed at which the bus arrives a little before its time, within its limit.
double BusVehicle::leg_speed(Time now) const {
  const RouteStop& to = route().stops[place_];
  const Passing& from = journey().passings[place_ - 1];
  const double metres = to.metres - drive_.metres();
  const double planned = std::max(1.0, seconds(passing().arrival - from.departure));
  const double left = seconds_left(now);
  const double road = std::clamp(1.5 * metres / planned, options_.speed_max, fastest);
  const double least = options_.delays ? slowest_in_traffic : slowest;
  const double haste = options_.delays ? 1 / mean_traffic : 1.2;
  return std::clamp(left <= 0 ? road : haste * metres / left, least, road);
}

/// Time in which the next stop is to be reached, but for what it takes to speed up and to brake.
double BusVehicle::seconds_left(Time now) const {
  constexpr double in_advance = 20;
  constexpr double speeding_up_and_braking = 7;
  const double planned = seconds(zero_ + passing().arrival - now);
  if (!options_.delays) return planned - in_advance;
  const Duration late = options_.delays->at(route().stops[place_].stop, route().is_backward,
                                            hour_of(passing().arrival));
  return planned + seconds(late) - speeding_up_and_braking;
}

void BusVehicle::begin_leg(Time now) {
  leg_began_ = now;
  stop_requested_ = false;
  green_at_ = never;
  light_ = -1;
  const double end = route().stops[place_].metres;
  const double way = end - drive_.metres();
  if (random_.below(100) < options_.red_light_percent) {
    const double share = lights_from + (lights_to - lights_from) * random_.below(1000) / 1000;
    light_ = drive_.metres() + way * share;
    // Too close to stop at the light: it counts as green.
    if (light_ - drive_.metres() <= drive_.braking_distance() + 1) light_ = -1;
  }
  const double traffic = traffic_from + traffic_more * random_.below(1000) / 1000;
  drive_.go(light_ >= 0 ? light_ : end, leg_speed(now) * traffic);
}

/// True if no passenger wants to get out, none waits at the stop, it is not too early, and the bus
/// has not braked to halt there.
bool BusVehicle::may_pass(Time now) const {
  if (is_last_stop() || light_ >= 0 || stop_requested_) return false;
  if (!has_passed_stop(0, drive_.speed())) return false;
  const bool is_awaited = !options_.has_unkind_driver && riders_.waiting_at(place_, now) > 0;
  if (now < leg_began_ + pass_not_before || is_awaited) return false;
  const double metres = route().stops[place_].metres - drive_.metres();
  return options_.has_hasty_driver || !passing().is_timing_point ||
         seconds(departure() - now) * std::max(drive_.speed(), slowest) <= metres;
}

/// Decides whether the bus passes the next stop, at the point where it would have to brake.
void BusVehicle::look_ahead(Time now) {
  constexpr double margin_m = 5;
  if (is_passing_ || drive_.rest() > drive_.braking_distance() + margin_m || !may_pass(now)) return;
  is_passing_ = true;
  drive_.go(route().stops[place_ + 1].metres, options_.speed_max);
}

/// Passes a stop without halting.
void BusVehicle::pass(Time now) {
  is_passing_ = false;
  delay_ = now - (zero_ + passing().arrival);
  fare_.reach(route().stops[place_].fare_zone, route().stops[place_].route_segment);
  riders_.leave(now, place_);
  tell(now, BusEvent::passes, place_);
  ++place_;
  begin_leg(now);
}

void BusVehicle::wait_for_green(Time now) {
  if (drive_.is_standing() && green_at_ == never) {
    green_at_ = now + 5s + Duration(1s) * random_.below(35);
  }
  if (now >= green_at_) go_on(now);
}

/// Drives to the next stop, whatever lights there were.
void BusVehicle::go_on(Time now) {
  light_ = -1;
  green_at_ = never;
  drive_.go(route().stops[place_].metres, leg_speed(now));
}

void BusVehicle::drive(Time now, Duration step) {
  drive_.step(step);
  if (state_ == BusState::transferring) {
    if (!drive_.is_standing()) return;
    return end_transfer(now);
  }
  if (light_ >= 0) return wait_for_green(now);
  if (is_passing_) {
    const double beyond = drive_.metres() - route().stops[place_].metres;
    if (has_passed_stop(beyond, drive_.speed()) || drive_.is_standing()) pass(now);
    return;
  }
  if (drive_.is_standing()) return arrive(now);
  look_ahead(now);
}

void BusVehicle::follow(Time now, const std::optional<RealMotion>& real) {
  const bool was_led = real_.has_value();
  real_ = real;
  if (state_ == BusState::at_stop) {
    if (real && real->speed > 0) next_look_ = now;
  } else if (was_led && !real) {  // the driver continues from this position
    if (state_ == BusState::driving) return go_on(now);
    drive_.go(transfer_.metres(), transfer_speed);
  }
}

/// Its doors are those of the real vehicle, and it leaves when the wheels of that one turn.
void BusVehicle::stand_as_real(Time now) {
  next_look_ = now + step_time;
  wants_to_go_ = wants_to_go_ || real_->speed > 0;
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    const bool is_known = (real_->known_doors >> i & 1) != 0;
    const bool is_open = is_known ? (real_->open_doors >> i & 1) != 0 : wants_doors(now);
    if (is_open && !wants_to_go_) {
      doors_[i].open(now);
    } else if (wants_to_go_ || is_known) {
      doors_[i].close(now);
    }
  }
  if (wants_to_go_ && are_closed()) is_last_stop() ? end_journey(now) : leave(now);
}

/// With closed doors, a real vehicle may stand at red lights near a stop.
bool BusVehicle::stands_at_stop(double beyond) const {
  if (real_->speed > 0 || std::abs(beyond) > near_stop_m) return false;
  const bool tells_doors = real_->known_doors != 0;
  return !tells_doors || std::abs(beyond) <= at_stop_m ||
         (real_->known_doors & real_->open_doors) != 0;
}

void BusVehicle::drive_as_real(Time now, Duration step) {
  drive_.roll(step, real_->speed);
  if (state_ == BusState::transferring) {
    if (real_->speed > 0 || transfer_.metres() - drive_.metres() > near_stop_m) return;
    return end_transfer(now);
  }
  const double beyond = drive_.metres() - route().stops[place_].metres;
  if (stands_at_stop(beyond)) return arrive(now);
  if (has_passed_stop(beyond, real_->speed) && !is_last_stop()) pass(now);
}

void BusVehicle::obstruct_door(Time now, std::size_t door, bool is_obstructed) {
  has_thing_[door] = is_obstructed;
  move_doors(now);
}

/// Passengers see the state of the doors, and the doors sense passengers.
void BusVehicle::move_doors(Time now) {
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    BusDoor& door = doors_[i];
    door.advance(now);
    door.obstruct(now, has_thing_[i] || riders_.is_in_doorway(i));
    if (door.state() == seen_[i]) continue;
    const bool was_open = seen_[i] == DoorState::open;
    seen_[i] = door.state();
    if (was_open != door.is_open()) riders_.door_changed(now, i, door.is_open());
    tell(now, BusEvent::door_changes, place_);
  }
}

Time BusVehicle::deadline() const {
  if (state_ == BusState::over) return never;
  Time next = riders_.deadline();
  if (state_ != BusState::at_stop) return std::min(next, last_ + step_time);
  for (const BusDoor& door : doors_) next = std::min(next, door.deadline());
  return std::min(next, next_look_);
}

void BusVehicle::advance(Time now) {
  if (state_ == BusState::over) return;
  riders_.advance(now);
  move_doors(now);
  if (state_ == BusState::at_stop) {
    if (now >= next_look_) real_ ? stand_as_real(now) : stand(now);
    move_doors(now);
  } else if (now >= last_ + step_time) {
    const Duration step = now - std::exchange(last_, now);
    real_ ? drive_as_real(now, step) : drive(now, step);
  }
}

}  // namespace canvoy::bus_line
