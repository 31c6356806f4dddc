// A bus line by its timetable: stops, routes with their fare zones and route segments, and the
// journeys of a day in blocks, one block for each vehicle. The terms are those of CiA 407: a block
// is the work of a vehicle from leaving the depot until its return, a route an ordered list of
// stops of a line, a journey one run over a route at a time (3.1).
//
//     const BusLine line = built_in_line();
//     const Journey& first = line.blocks.front().journeys.front();
//     line.stop(first.route, 0).name;
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/bus_line/path.hpp"

namespace canvoy::bus_line {

/// A stop with its place and names; the texts of displays are made of it.
struct BusStop {
  std::uint32_t number = 0;  ///< stop point ID (6109h), from 1 on
  std::string id{};          ///< as in the timetable
  std::string name{};        ///< as announced and shown, UTF-8
  std::string short_name{};  ///< where a display has no room for the name; empty: there is none
  GeoPoint place{};          ///< where the bus stands
};

/// A stop of a route.
struct RouteStop {
  std::size_t stop = 0;        ///< index in BusLine::stops
  double metres = 0;           ///< along the path of the route; never decreases
  std::uint8_t fare_zone = 0;  ///< number of its zone (6111h)
  /// The link that begins here, by its number, unique within the fare zone. For the last stop, the
  /// link that ends here, unless that is in another zone.
  std::uint16_t route_segment = 0;
  /// Destination from here to the next stop; empty: that of the route.
  std::string destination{};
};

/// Names of a line.
struct LineNames {
  std::uint32_t number = 0;  ///< 6192h
  std::string id{};          ///< as in the timetable
  std::string name{};        ///< for passengers
};

/// A list of stops in the order of driving, with the way between them.
struct BusRoute {
  std::uint32_t number = 0;        ///< 6193h, from 1 on
  std::string destination{};       ///< shown on the way, UTF-8
  bool is_backward = false;        ///< 6108h
  std::vector<RouteStop> stops{};  ///< at least two
  Path path{};                     ///< ground that the bus covers; starts and ends with the stops
  /// Line of the route, where it is not that of the BusLine: a block may consist of several lines
  /// (3.1.2).
  std::optional<LineNames> other_line{};

  /// Destination of a vehicle that has reached that stop, and not yet the next one.
  const std::string& destination_at(std::size_t reached) const {
    const std::string& own = stops[reached].destination;
    return own.empty() ? destination : own;
  }
};

/// Times of a journey at a stop, since the beginning of the day of service: above 24 h after its
/// midnight.
struct Passing {
  Duration arrival{};           ///< at the stop
  Duration departure{};         ///< from the stop; not before the arrival
  std::uint32_t sequence = 0;   ///< stop_sequence of a GTFS feed
  bool is_timing_point = true;  ///< the vehicle does not leave before `departure`
  bool boards = true;           ///< passengers may get in
  bool alights = true;          ///< passengers may get out
};

/// One run over a route, at its times.
struct Journey {
  std::uint32_t number = 0;         ///< 6195h, from 1 on
  std::string trip{};               ///< as in the timetable
  std::size_t route = 0;            ///< index in BusLine::routes
  std::vector<Passing> passings{};  ///< one for each stop of the route, at least two
  bool is_repeated = false;         ///< one of several of this trip, which differ in their
                                    ///< departures
};

/// Work of a vehicle from leaving the depot until its return.
struct Block {
  std::uint32_t number = 0;         ///< 6194h, from 1 on
  std::string id{};                 ///< as in the timetable
  std::vector<Journey> journeys{};  ///< in the order of their times
};

struct BusLine {
  std::uint32_t number = 0;        ///< 6192h
  std::string id{};                ///< as in the timetable
  std::string name{};              ///< for passengers
  std::vector<BusStop> stops{};    ///< of all routes
  std::vector<BusRoute> routes{};  ///< of all journeys
  std::vector<Block> blocks{};     ///< of the day; one for each vehicle

  /// Stop of a route, by indices in routes and BusRoute::stops.
  const BusStop& stop(std::size_t route, std::size_t place) const {
    return stops[routes[route].stops[place].stop];
  }
  /// Names of the line of a route.
  LineNames names_of(const BusRoute& route) const {
    return route.other_line.value_or(LineNames{number, id, name});
  }
};

/// Numbers the route segments: each ends after `links` links, and at the border of a fare zone.
/// Where a route returns to a zone, the numbers continue.
void number_segments(BusRoute& route, unsigned links);

/// A line of eight stops in two fare zones that runs from 5:00 to 24:20 every 40 minutes, with one
/// vehicle.
BusLine built_in_line();

}  // namespace canvoy::bus_line
