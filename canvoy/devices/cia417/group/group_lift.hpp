// What a dispatcher knows of one lift of its group, and how long the lift takes to come somewhere.
//
//     GroupLift lift{.in_service = true, .floor = 1, .served = {FloorSet::between(1, 20)}};
//     estimate_arrival(route_of(lift), {.floor = 8, .direction = Direction::down}, lift.times)
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/controller/collective_control.hpp"
#include "canvoy/devices/cia417/panel/virtual_io.hpp"

namespace canvoy::cia417 {

inline constexpr unsigned group_lifts_max = 8;
inline constexpr unsigned lift_doors_max = 4;
/// Lifts of a group, see lift_bit().
using LiftMask = std::uint8_t;

/// For estimates; the lift's own data give them (see the round-trip time of a building).
struct TravelTimes {
  Duration flight = 1500ms;  ///< of one floor at rated speed
  Duration stop = 8s;        ///< that a stop costs: braking, doors, people, starting
};

struct GroupLift {
  /// Takes hall calls: not while it is faulty, on a service of its own, or not heard.
  bool in_service = false;
  bool full = false;
  /// Where it stands; while it moves, the first floor at which it can still stop.
  std::uint8_t floor = 1;
  Direction direction = Direction::none;
  /// What those who are in the car want.
  FloorSet car_calls{};
  /// The floors that have a door, for each door.
  std::array<FloorSet, lift_doors_max> served{};
  std::uint8_t persons_max = 13;
  TravelTimes times{};

  /// It has all these doors there, and one at least is meant.
  bool serves(std::uint8_t floor_wanted, DoorMask doors) const;
  /// It has a floor to go to from there in this direction; without one it always has.
  bool leaves(std::uint8_t from, Direction way) const;
  /// The doors that it has there.
  DoorMask doors_at(std::uint8_t floor_wanted) const;
};

/// Where somebody waits for the car.
struct Landing {
  std::uint8_t floor = 0;
  Direction direction = Direction::none;  ///< where he wants to go; none: is not known
};

/// A car and its stops.
struct Route {
  std::uint8_t floor = 1;
  Direction direction = Direction::none;
  FloorSet stops_up{};    ///< where it stops on its way up
  FloorSet stops_down{};  ///< where it stops on its way down
  /// In its direction after it has turned twice: for those who wait behind it, and where these want
  /// to go. It does not go there before.
  FloorSet stops_later{};

  FloorSet stops() const { return stops_up | stops_down; }
  FloorSet all() const { return stops() | stops_later; }
  /// Those of the way on which it comes to a landing.
  FloorSet& stops_of(const Landing& landing);
  const FloorSet& stops_of(const Landing& landing) const;
};
/// The stops for those who are in the car.
Route route_of(const GroupLift& lift);

/// What one dispatcher knows of the plans of the other one of its group: a car has one way for hall
/// calls and destination calls. What is empty adds nothing.
struct OtherPlans {
  /// Adds the stops of a lift to its route.
  Callback<void(unsigned lift, Route&)> add_stops;
  /// How many people a stop there delays, beside one for each car call.
  Callback<unsigned(unsigned lift, const Landing&)> delayed;
  /// The car will leave there with no room.
  Callback<bool(unsigned lift, const Landing&)> is_full;
};

/// Whether the car comes there before it has turned twice.
bool comes_by(const GroupLift& lift, const Landing& landing);

/// How long a car under collective control takes to come to a landing, in the direction that is
/// wanted there: over its turning points, and with the stops on the way.
Duration estimate_arrival(const Route& route, const Landing& landing, const TravelTimes& times);
/// Without a turn: from one floor to another, and the stops between them.
Duration estimate_leg(const FloorSet& stops, std::uint8_t from, std::uint8_t to,
                      const TravelTimes& times);

}  // namespace canvoy::cia417
