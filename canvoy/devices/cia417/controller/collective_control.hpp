// Full collective control of one lift: in which order it answers its calls. A car collects what
// lies on its way, turns where nothing is left ahead, and stops for those who want to go its way
// only.
//
//     const NextStop stop = next_stop(calls, {.floor = 4, .direction = Direction::up});
//     if (stop.floor != 0) motion.travel_to(height_of(stop.floor));
//
// Calls of high priority come first: while there is one, the car stops for such calls alone. Calls
// of low priority are taken along where they lie on the way to others, and draw the car by
// themselves when there are no others; LiftCalls::promote_low() keeps them from waiting for ever.
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/controller/lift_calls.hpp"

namespace canvoy::cia417 {

enum class Direction : std::int8_t { down = -1, none = 0, up = 1 };

/// Of up and down the other one.
constexpr Direction reverse(Direction direction) {
  return direction == Direction::up ? Direction::down : Direction::up;
}

struct CollectiveCar {
  /// Where it stands; while it moves, the first floor at which it can still stop.
  std::uint8_t floor = 1;
  /// Where it goes, or promised to go those who entered.
  Direction direction = Direction::none;
  bool moving = false;
  /// Not when it is full, or serves the car calls only.
  bool takes_hall_calls = true;
};

struct NextStop {
  std::uint8_t floor = 0;                 ///< 0: no call
  Direction departure = Direction::none;  ///< where it goes on from there: for the lantern
  DoorMask doors = 0;                     ///< that have to open; none where it just ends
  friend constexpr bool operator==(const NextStop&, const NextStop&) = default;
};

/// Where the car goes next. Its own floor, where a call is to be answered there. A moving car that
/// has nothing ahead any more ends at the first floor that it can.
NextStop next_stop(const LiftCalls& calls, const CollectiveCar& car);

/// The direction in which a car that came in `car.direction` leaves the floor where it stands: on
/// as before while somebody wants that, else back, or none.
Direction departure(const LiftCalls& calls, const CollectiveCar& car);

/// What is answered by a stop of a car that leaves in this direction. Without one nobody waits who
/// has said where to.
CallKinds answered_calls(Direction departure);

}  // namespace canvoy::cia417
