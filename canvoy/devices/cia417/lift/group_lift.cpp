#include "canvoy/devices/cia417/lift/group_lift.hpp"

#include <algorithm>

namespace canvoy::cia417 {

namespace {

constexpr bool is_ahead(std::uint8_t floor, std::uint8_t of, Direction direction) {
  return direction == Direction::up ? floor >= of : floor <= of;
}
/// Of two floors, the one that is farther in this direction.
constexpr std::uint8_t farther(std::uint8_t a, std::uint8_t b, Direction direction) {
  return direction == Direction::up ? std::max(a, b) : std::min(a, b);
}

/// The last stop in this direction, or `floor` if there is none beyond it.
std::uint8_t end_of(const FloorSet& stops, std::uint8_t floor, Direction direction) {
  if (stops.empty()) return floor;
  const std::uint8_t last = direction == Direction::up ? stops.highest() : stops.lowest();
  return farther(floor, last, direction);
}

Duration flight(std::uint8_t from, std::uint8_t to, const TravelTimes& times) {
  return (from > to ? from - to : to - from) * times.flight;
}

FloorSet Route::*set_of(const Route& route, const Landing& landing) {
  const bool is_behind = route.direction != Direction::none &&
                         landing.direction == route.direction &&
                         !is_ahead(landing.floor, route.floor, route.direction);
  if (is_behind) return &Route::stops_later;
  return landing.direction == Direction::down ? &Route::stops_down : &Route::stops_up;
}

}  // namespace

bool GroupLift::serves(std::uint8_t floor_wanted, DoorMask doors) const {
  return doors != 0 && (doors & ~doors_at(floor_wanted)) == 0;
}

bool GroupLift::leaves(std::uint8_t from, Direction way) const {
  FloorSet floors;
  for (const FloorSet& of_door : served) floors |= of_door;
  if (way == Direction::up) return floors.highest() > from;
  return way == Direction::none || (floors.lowest() != 0 && floors.lowest() < from);
}

DoorMask GroupLift::doors_at(std::uint8_t floor_wanted) const {
  unsigned doors = 0;
  for (unsigned door = 0; door < lift_doors_max; ++door) {
    if (served[door].contains(floor_wanted)) doors |= 1U << door;
  }
  return static_cast<DoorMask>(doors);
}

Route route_of(const GroupLift& lift) {
  return {lift.floor, lift.direction, lift.car_calls, lift.car_calls};
}

FloorSet& Route::stops_of(const Landing& landing) {
  return this->*set_of(*this, landing);
}
const FloorSet& Route::stops_of(const Landing& landing) const {
  return this->*set_of(*this, landing);
}

bool comes_by(const GroupLift& lift, const Landing& landing) {
  if (lift.direction == Direction::none || landing.direction == reverse(lift.direction)) {
    return true;
  }
  return is_ahead(landing.floor, lift.floor, lift.direction);
}

Duration estimate_leg(const FloorSet& stops, std::uint8_t from, std::uint8_t to,
                      const TravelTimes& times) {
  const unsigned low = std::min(from, to);
  const unsigned high = std::max(from, to);
  const FloorSet between = high > low ? FloorSet::between(low + 1, high - 1) : FloorSet{};
  return flight(from, to, times) + (stops & between).size() * times.stop;
}

Duration estimate_arrival(const Route& route, const Landing& landing, const TravelTimes& times) {
  const auto stops_on = [&](Direction way) -> const FloorSet& {
    return way == Direction::down ? route.stops_down : route.stops_up;
  };
  if (route.direction == Direction::none) {
    const bool goes_down = landing.floor < route.floor;
    return estimate_leg(stops_on(goes_down ? Direction::down : Direction::up), route.floor,
                        landing.floor, times);
  }
  const Direction onward = route.direction;
  const Direction back = reverse(onward);
  const bool lies_ahead = is_ahead(landing.floor, route.floor, onward);
  if (lies_ahead && landing.direction != back) {
    return estimate_leg(stops_on(onward), route.floor, landing.floor, times);
  }
  // To the end, and back.
  std::uint8_t turn = end_of(route.stops(), route.floor, onward);
  if (lies_ahead) turn = farther(turn, landing.floor, onward);
  Duration time = estimate_leg(stops_on(onward), route.floor, turn, times);
  if (turn != landing.floor && turn != route.floor) time += times.stop;
  if (landing.direction != onward) {
    return time + estimate_leg(stops_on(back), turn, landing.floor, times);
  }
  // To the other end, and back again.
  const std::uint8_t second = farther(end_of(route.all(), turn, back), landing.floor, back);
  time += estimate_leg(stops_on(back), turn, second, times);
  if (second != landing.floor) time += times.stop;
  return time + estimate_leg(route.stops_later, second, landing.floor, times);
}

}  // namespace canvoy::cia417
