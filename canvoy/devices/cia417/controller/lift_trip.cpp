// Where the car goes: LiftController between its stops.
#include <algorithm>
#include <cstdlib>

#include "canvoy/devices/cia417/controller/lift_controller.hpp"

namespace canvoy::cia417 {

void LiftController::enter(LiftPhase phase) {
  phase_ = phase;
  promised_ = {};
  again_ = true;
}

CollectiveCar LiftController::car_at(std::uint8_t floor, bool moving) const {
  const bool takes = !is_full() && accepted() == all_calls;
  return {.floor = floor, .direction = direction_, .moving = moving, .takes_hall_calls = takes};
}

/// The next stop by the service that is on: for the fire recall one floor, out of order the first.
NextStop LiftController::wanted_stop(std::uint8_t floor, bool moving) const {
  if (service_ == LiftService::out_of_order) {
    return {.floor = moving ? next_served_floor(floor) : std::uint8_t{0}};
  }
  if (service_ != LiftService::fire_recall) return next_stop(calls_.calls(), car_at(floor, moving));
  const std::uint8_t fire_floor = settings_.fire_floor;
  const bool lies_behind = direction_ == Direction::up ? fire_floor < floor : fire_floor > floor;
  if (moving && lies_behind) return {.floor = floor};
  if (is_cleared_) return {};
  return {.floor = fire_floor, .doors = calls_.doors_at(fire_floor)};
}

void LiftController::idle() {
  if (!motion_.standing) return;
  if (node_.now() < resume_at_) return wake_at(resume_at_);
  // Doors that were told to open, and did not, may still do so.
  if (!is_locked() || open_doors_ != 0) return close_doors();
  if (service_ == LiftService::service_run || service_ == LiftService::dogging) {
    return enter(LiftPhase::manual);
  }
  const std::uint8_t floor = floor_here();
  if (floor != 0) return begin_trip(floor);
  // Between floors, after a fault: to the next one, and on from there.
  is_errand_ = true;
  go_to(nearest_served_floor(nearest_floor(motion_.position_micrometre)));
}

void LiftController::begin_trip(std::uint8_t floor) {
  const DoorMask here = calls_.doors_at(floor) & settings_.doors;
  if (service_ == LiftService::out_of_order) {
    if (is_cleared_) return;
    return here != 0 ? stop_at(floor, here) : leave_for_a_door(floor);
  }
  if (load_.overload) return here != 0 ? stop_at(floor, here) : void();
  if (is_open_wanted() && here != 0) {
    const DoorMask held = calls_.held_doors(SpecialFunction::door_open) & here;
    return stop_at(floor, held != 0 ? held : here);
  }
  // The fire brigade opens with the button for it, also where it is already.
  if (service_ == LiftService::fire_brigade) calls_.answered(floor, Direction::none);
  const NextStop stop = wanted_stop(floor, false);
  if (stop.floor == 0) return park(floor);
  if (stop.floor == floor) return stop_at(floor, stop.doors);
  is_errand_ = false;
  go_to(stop.floor);
}

/// Stands where it has no door: people get out at the nearest floor that has one.
void LiftController::leave_for_a_door(std::uint8_t floor) {
  const std::uint8_t nearest = nearest_served_floor(floor);
  if (nearest == floor) return;
  is_errand_ = true;
  go_to(nearest);
}

void LiftController::park(std::uint8_t floor) {
  direction_ = Direction::none;
  const bool away = settings_.parking_floor != 0 && settings_.parking_floor != floor;
  if (!away || service_ != LiftService::normal) return;
  const Time at = idle_since_ + settings_.times.parking;
  if (node_.now() < at) return wake_at(at);
  is_errand_ = true;
  go_to(settings_.parking_floor);
}

void LiftController::go_to(std::uint8_t floor) {
  target_ = floor;
  // It does not go back to where it has just left, as a call that comes late would have it.
  departed_ = floor_here();
  const std::int32_t position = position_of(floor);
  const std::int32_t here = motion_.position_micrometre;
  if (position != here) direction_ = position > here ? Direction::up : Direction::down;
  deadline_ = node_.now() + settings_.times.travel_max;
  enter(LiftPhase::driving);
  parts_.motion.travel_to(position);
}

void LiftController::drive() {
  if (motion_.standing) return arrive();
  if (node_.now() >= deadline_) {
    latched_ = LiftFault::travel_time;
    again_ = true;
    return;
  }
  wake_at(deadline_);
  follow_calls();
}

/// What comes while the car moves: calls on its way, or none any more.
void LiftController::follow_calls() {
  const std::int32_t left = motion_.stopping_position_micrometre - position_of(target_);
  const bool ends = (doors_.faulty & settings_.doors) != 0 || !load_.known;
  if (std::abs(left) <= settings_.floor_tolerance_micrometre) {
    promised_ = ends ? NextStop{} : promised_stop();
    return;
  }
  const std::uint8_t reachable = reachable_floor();
  const NextStop stop =
      ends ? NextStop{.floor = next_served_floor(reachable)} : wanted_stop(reachable, true);
  const bool is_called = stop.doors != 0 || ends || service_ == LiftService::fire_recall ||
                         service_ == LiftService::out_of_order;
  if (stop.floor == 0 || stop.floor == target_ || (is_errand_ && !is_called)) return;
  is_errand_ = false;
  target_ = stop.floor;
  parts_.motion.travel_to(position_of(target_));
}

/// The stop to which the car slows down, for those who see its lantern there: where it goes on to
/// does not change any more while somebody wants that. None where no door will open.
NextStop LiftController::promised_stop() const {
  CollectiveCar car = car_at(target_, true);
  if (promised_.departure != Direction::none) car.direction = promised_.departure;
  const NextStop stop = next_stop(calls_.calls(), car);
  return stop.floor == target_ && stop.doors != 0 ? stop : NextStop{};
}

/// Where the drive says so, or where it has given up: at its target it has arrived all the same.
void LiftController::arrive() {
  const std::uint8_t floor = floor_here();
  if (floor == 0 || (!motion_.arrived && floor != target_)) {
    latched_ = LiftFault::position;
    again_ = true;
    return;
  }
  target_ = 0;
  is_errand_ = false;
  idle_since_ = node_.now();
  // What the lantern promised holds while somebody wants it.
  if (promised_.departure != Direction::none) direction_ = promised_.departure;
  // The fire brigade opens by itself, where it has seen what is behind the door.
  if (service_ == LiftService::fire_brigade) calls_.answered(floor, Direction::none);
  const NextStop stop = wanted_stop(floor, false);
  if (stop.floor == floor && stop.doors != 0) return stop_at(floor, stop.doors);
  enter(LiftPhase::idle);
}

/// By a fault. When it has gone, the lift goes on after a while.
void LiftController::stand() {
  if (fault_ == LiftFault::none) {
    if (node_.now() < resume_at_) return wake_at(resume_at_);
    idle_since_ = node_.now();
    return enter(LiftPhase::idle);
  }
  let_out();
  if (latched_ == LiftFault::none || !motion_.standing || !motion_.available) return;
  if (deadline_ == never) deadline_ = node_.now() + settings_.times.retry;
  if (node_.now() < deadline_) return wake_at(deadline_);
  latched_ = LiftFault::none;
  again_ = true;
}

/// Who is in the car of a lift that has a fault gets out where there is a floor.
void LiftController::let_out() {
  const std::uint8_t floor = floor_here();
  if (floor == 0) return;
  const Time steady_at = steady_since_ + settings_.times.steady;
  if (node_.now() < steady_at) return wake_at(steady_at);
  const auto doors = static_cast<DoorMask>(calls_.doors_at(floor) & settings_.doors &
                                           ~doors_.faulty & ~open_doors_);
  if (doors == 0) return;
  open_doors_ |= doors;
  parts_.doors.open(doors);
}

/// By two buttons, while one of them is held, and not beyond the first and the last floor. A car
/// that comes to rest short of these goes on when the button is held anew.
void LiftController::drive_by_hand() {
  departed_ = 0;
  const bool is_manual = service_ == LiftService::service_run || service_ == LiftService::dogging;
  const bool up = calls_.is_on(SpecialFunction::dogging_service_up);
  const bool down = calls_.is_on(SpecialFunction::dogging_service_down);
  const std::int32_t end = motion_.stopping_position_micrometre;
  int wanted = 0;
  if (is_manual && is_locked() && up != down) wanted = up ? 1 : -1;
  if (wanted != end_) end_ = 0;
  if (wanted > 0 && end >= settings_.floors.back()) end_ = 1;
  if (wanted < 0 && end <= settings_.floors.front()) end_ = -1;
  if (end_ != 0) wanted = 0;
  if (wanted != by_hand_) {
    by_hand_ = static_cast<std::int8_t>(wanted);
    direction_ = static_cast<Direction>(wanted);
    const std::int32_t speed = service_ == LiftService::dogging
                                   ? settings_.dogging_speed_micrometre_per_second
                                   : settings_.service_speed_micrometre_per_second;
    if (wanted == 0) {
      parts_.motion.stop();
    } else {
      parts_.motion.run(wanted * speed);
    }
  }
  if (!is_manual && motion_.standing) enter(LiftPhase::idle);
}

}  // namespace canvoy::cia417
