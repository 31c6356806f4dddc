// Full collective control of one lift: the order in which it answers its calls. A car collects the
// calls on its way, turns when there are none ahead, and stops only for passengers in its
// direction.
//
//     const NextStop stop = next_stop(calls, {.floor = 4, .direction = Direction::up});
//     if (stop.floor != 0) motion.travel_to(height_of(stop.floor));
//
// Calls of high priority come first: while there is one, the car stops only for such calls. Calls
// of low priority are answered on the way to others, and move the car by themselves only if there
// are no others; LiftCalls::promote_low() limits their waiting time.
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/lift/lift_calls.hpp"

namespace canvoy::cia417 {

/// Direction of travel; none: at rest, or of no importance.
enum class Direction : std::int8_t { down = -1, none = 0, up = 1 };

/// The opposite of up or down.
constexpr Direction reverse(Direction direction) {
  return direction == Direction::up ? Direction::down : Direction::up;
}

/// A car as the search for its next stop sees it.
struct CollectiveCar {
  /// Floor at which it stands; while it moves, the first floor at which it can still stop.
  std::uint8_t floor = 1;
  /// Its direction, or the one shown to passengers who got in.
  Direction direction = Direction::none;
  bool moving = false;  ///< between floors
  /// False when it is full, or serves only car calls.
  bool takes_hall_calls = true;
};

/// Result of a search.
struct NextStop {
  std::uint8_t floor = 0;                 ///< 0: no call
  Direction departure = Direction::none;  ///< direction in which it leaves, for the lantern
  DoorMask doors = 0;                     ///< doors that have to open; none if the trip just ends
  friend constexpr bool operator==(const NextStop&, const NextStop&) = default;
};

/// The next stop of the car; its own floor, if it has to answer a call there. A moving car with no
/// call ahead ends at the first floor that it can reach.
NextStop next_stop(const LiftCalls& calls, const CollectiveCar& car);

/// Direction in which a car that came in `car.direction` leaves the floor where it stands: the same
/// while there are calls ahead, otherwise the opposite, or none.
Direction departure(const LiftCalls& calls, const CollectiveCar& car);

/// Kinds of calls answered by a stop of a car that leaves in this direction. Without a direction,
/// no passenger waits for one.
CallKinds answered_calls(Direction departure);

}  // namespace canvoy::cia417
