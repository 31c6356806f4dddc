// State of one lift of a group for its dispatcher, and estimates of its travel times.
//
//     GroupLift lift{.in_service = true, .floor = 1, .served = {FloorSet::between(1, 20)}};
//     estimate_arrival(route_of(lift), {.floor = 8, .direction = Direction::down}, lift.times)
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/lift/collective_control.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

inline constexpr unsigned group_lifts_max = 8;  ///< a bit each in the records
inline constexpr unsigned lift_doors_max = 4;   ///< a bit each in the records
/// Lifts of a group, see lift_bit().
using LiftMask = std::uint8_t;

/// For estimates; they follow from the lift's own data (see the round-trip time of a building).
struct TravelTimes {
  Duration flight = 1500ms;  ///< of one floor at rated speed
  Duration stop = 8s;        ///< cost of a stop: braking, doors, passengers, starting
};

struct GroupLift {
  /// True if it takes hall calls: not while it is faulty, in a separate service, or not received.
  bool in_service = false;
  bool full = false;  ///< takes no further passengers
  /// Floor at which it stands; while it moves, the first floor at which it can still stop.
  std::uint8_t floor = 1;
  Direction direction = Direction::none;  ///< of its present travel
  /// Calls of passengers in the car.
  FloorSet car_calls{};
  /// Floors with a door, for each door.
  std::array<FloorSet, lift_doors_max> served{};
  std::uint8_t persons_max = 13;  ///< of the car, by its size
  TravelTimes times{};            ///< of its doors and its drive

  /// True if it has all these doors there, and at least one is given.
  bool serves(std::uint8_t floor_wanted, DoorMask doors) const;
  /// True if there is a further floor from there in this direction; always true without a
  /// direction.
  bool leaves(std::uint8_t from, Direction way) const;
  /// The doors that it has there.
  DoorMask doors_at(std::uint8_t floor_wanted) const;
};

/// The location of a passenger who waits for the car.
struct Landing {
  std::uint8_t floor = 0;                 ///< from 1
  Direction direction = Direction::none;  ///< wanted direction; none: not known
};

/// A car and its stops.
struct Route {
  std::uint8_t floor = 1;                 ///< the present one, or the next
  Direction direction = Direction::none;  ///< of the travel
  FloorSet stops_up{};                    ///< stops on its way up
  FloorSet stops_down{};                  ///< stops on its way down
  /// Stops in its direction after it has turned twice: of passengers who wait behind it, and their
  /// destinations.
  FloorSet stops_later{};

  /// All stops of this round trip.
  FloorSet stops() const { return stops_up | stops_down; }
  /// All stops, of the next round trip too.
  FloorSet all() const { return stops() | stops_later; }
  /// Stops of the section in which it reaches a landing.
  FloorSet& stops_of(const Landing& landing);
  /// Stops in the direction of a landing.
  const FloorSet& stops_of(const Landing& landing) const;
};
/// The stops for the passengers in the car.
Route route_of(const GroupLift& lift);

/// Plans of the other dispatcher of a group: a car has one route for hall calls and destination
/// calls. Empty callbacks add nothing.
struct OtherPlans {
  /// Adds the stops of a lift to its route.
  Callback<void(unsigned lift, Route&)> add_stops;
  /// Number of passengers that a stop there delays, beside one for each car call.
  Callback<unsigned(unsigned lift, const Landing&)> delayed;
  /// True if the car leaves there without room.
  Callback<bool(unsigned lift, const Landing&)> is_full;
};

/// True if the car comes there before it has turned twice.
bool comes_by(const GroupLift& lift, const Landing& landing);

/// Time for a car under collective control to reach a landing, in the direction wanted there: over
/// its turning points, and with the stops on the way.
Duration estimate_arrival(const Route& route, const Landing& landing, const TravelTimes& times);
/// Time without a turn: from one floor to another, with the stops between them.
Duration estimate_leg(const FloorSet& stops, std::uint8_t from, std::uint8_t to,
                      const TravelTimes& times);

}  // namespace canvoy::cia417
