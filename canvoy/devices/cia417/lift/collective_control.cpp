#include "canvoy/devices/cia417/lift/collective_control.hpp"

namespace canvoy::cia417 {

namespace {

/// The calls that count at present.
struct Wanted {
  FloorSet always;     ///< a car stops there in either direction
  FloorSet hall_up;    ///< there on its way up, too
  FloorSet hall_down;  ///< there on its way down, too
  FloorSet deciding;   ///< calls that move the car

  FloorSet stops_up() const { return always | hall_up; }
  FloorSet stops_down() const { return always | hall_down; }
  bool is_beyond(std::uint8_t floor, Direction direction) const {
    if (direction == Direction::up) return deciding.highest() > floor;
    return deciding.lowest() != 0 && deciding.lowest() < floor;
  }
};

constexpr CallKinds answerable(const CollectiveCar& car) {
  return car.takes_hall_calls ? all_calls : car_calls;
}

Wanted urgent_calls(const LiftCalls& calls, CallKinds kinds) {
  const auto set = [&](unsigned of) {
    return calls.floors(static_cast<CallKinds>(of & kinds), CallPriority::high);
  };
  return {set(calls_up & calls_down), set(kinds_of(CallKind::up)), set(kinds_of(CallKind::down)),
          set(all_calls)};
}

Wanted usual_calls(const LiftCalls& calls, CallKinds kinds) {
  const auto set = [&](unsigned of) { return calls.floors(static_cast<CallKinds>(of & kinds)); };
  Wanted wanted{
      set(calls_up & calls_down), set(kinds_of(CallKind::up)), set(kinds_of(CallKind::down)),
      calls.floors(kinds, CallPriority::standard) | calls.floors(kinds, CallPriority::high)};
  if (wanted.deciding.empty()) wanted.deciding = set(all_calls);
  return wanted;
}

Wanted wanted_calls(const LiftCalls& calls, CallKinds kinds) {
  const Wanted urgent = urgent_calls(calls, kinds);
  return urgent.deciding.empty() ? usual_calls(calls, kinds) : urgent;
}

/// The next stop in this direction, including the car's floor; 0: none.
std::uint8_t next_ahead(const Wanted& wanted, std::uint8_t floor, Direction direction) {
  if (direction == Direction::up) {
    const std::uint8_t end = wanted.deciding.highest();
    if (end < floor) return 0;
    const std::uint8_t stop = wanted.stops_up().next_up(floor);
    return stop != 0 && stop <= end ? stop : end;
  }
  const std::uint8_t end = wanted.deciding.lowest();
  if (end == 0 || end > floor) return 0;
  const std::uint8_t stop = wanted.stops_down().next_down(floor);
  return stop >= end ? stop : end;
}

/// First direction of a car that has not shown one.
Direction first_direction(const Wanted& wanted, std::uint8_t floor) {
  if (wanted.deciding.contains(floor)) {
    return wanted.stops_up().contains(floor) ? Direction::up : Direction::down;
  }
  const std::uint8_t above = wanted.deciding.next_up(floor);
  const std::uint8_t below = wanted.deciding.next_down(floor);
  if (above == 0 && below == 0) return Direction::none;
  if (above == 0) return Direction::down;
  if (below == 0) return Direction::up;
  return above - floor <= floor - below ? Direction::up : Direction::down;
}

Direction departure_among(const Wanted& wanted, std::uint8_t floor, Direction arrival) {
  const Direction first = arrival == Direction::none ? Direction::up : arrival;
  for (const Direction direction : {first, reverse(first)}) {
    const FloorSet& hall = direction == Direction::up ? wanted.hall_up : wanted.hall_down;
    if (hall.contains(floor) || wanted.is_beyond(floor, direction)) return direction;
  }
  return Direction::none;
}

}  // namespace

Direction departure(const LiftCalls& calls, const CollectiveCar& car) {
  const CallKinds kinds = answerable(car);
  const Direction urgent = departure_among(urgent_calls(calls, kinds), car.floor, car.direction);
  if (urgent != Direction::none) return urgent;
  return departure_among(usual_calls(calls, kinds), car.floor, car.direction);
}

CallKinds answered_calls(Direction departure) {
  if (departure == Direction::up) return calls_up;
  if (departure == Direction::down) return calls_down;
  return all_calls;
}

NextStop next_stop(const LiftCalls& calls, const CollectiveCar& car) {
  const CallKinds kinds = answerable(car);
  const Wanted wanted = wanted_calls(calls, kinds);
  Direction direction = car.direction;
  if (direction == Direction::none) direction = first_direction(wanted, car.floor);
  if (direction == Direction::none) return {};

  std::uint8_t floor = next_ahead(wanted, car.floor, direction);
  if (floor == 0 && car.moving) return {.floor = car.floor};
  if (floor == 0) {
    direction = reverse(direction);
    floor = next_ahead(wanted, car.floor, direction);
  }
  if (floor == 0) return {};
  const Direction leaves = departure(
      calls, {.floor = floor, .direction = direction, .takes_hall_calls = car.takes_hall_calls});
  const auto answered = static_cast<CallKinds>(answered_calls(leaves) & kinds);
  return {.floor = floor, .departure = leaves, .doors = calls.doors_at(floor, answered)};
}

}  // namespace canvoy::cia417
