// A bus line as it stands in a timetable: stops, routes with their fare zones and route segments,
// and the journeys of a day in blocks, one block a vehicle. The words are those of CiA 407 (clause
// 3.1): a block is what a vehicle does from leaving the depot until its return, a route an ordered
// list of stops of a line, a journey one run over a route at a time.
//
//     const BusLine line = built_in_line();
//     const Journey& first = line.blocks.front().journeys.front();
//     line.stop(first.route, 0).name;
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/bus/path.hpp"

namespace canvoy::bus {

struct BusStop {
  std::uint32_t number = 0;  ///< stop point ID (6109h), from 1 on
  std::string id{};          ///< as the timetable has it
  std::string name{};
  std::string short_name{};
  GeoPoint place{};
};

/// A stop of a route.
struct RouteStop {
  std::size_t stop = 0;  ///< of BusLine::stops
  double metres = 0;     ///< along the path of the route; never falls
  std::uint8_t fare_zone = 0;
  /// Of the link that begins here, unique within the fare zone; of the last stop that of the link
  /// that ends here, unless it is in another zone.
  std::uint16_t route_segment = 0;
};

struct BusRoute {
  std::uint32_t number = 0;  ///< 6193h, from 1 on
  std::string destination{};
  bool is_backward = false;  ///< 6108h
  std::vector<RouteStop> stops{};
  Path path{};
};

/// When a journey is at a stop, since the beginning of the day of service: above 24 h after its
/// midnight.
struct Passing {
  Duration arrival{};
  Duration departure{};
  std::uint32_t sequence = 0;   ///< stop_sequence of a GTFS feed
  bool is_timing_point = true;  ///< nobody leaves before `departure`
  bool boards = true;           ///< passengers may get in
  bool alights = true;          ///< and out
};

struct Journey {
  std::uint32_t number = 0;         ///< 6194h, from 1 on
  std::string trip{};               ///< as the timetable has it
  std::size_t route = 0;            ///< of BusLine::routes
  std::vector<Passing> passings{};  ///< one for each stop of the route, two at least
  bool is_repeated = false;         ///< one of several of this trip: its departure tells which
};

struct Block {
  std::uint32_t number = 0;  ///< 6191h, from 1 on
  std::string id{};
  std::vector<Journey> journeys{};  ///< in the order of their times
};

struct BusLine {
  std::uint32_t number = 0;  ///< 6192h
  std::string id{};          ///< as the timetable has it
  std::string name{};        ///< as passengers know it
  std::vector<BusStop> stops{};
  std::vector<BusRoute> routes{};
  std::vector<Block> blocks{};

  const BusStop& stop(std::size_t route, std::size_t place) const {
    return stops[routes[route].stops[place].stop];
  }
};

/// Numbers the route segments: each ends after `links` links, and at the border of a fare zone.
/// Where a route comes back into a zone, it goes on counting.
void number_segments(BusRoute& route, unsigned links);

/// A line of eight stops in two fare zones that runs from 5:00 to 24:20 every 40 minutes, with one
/// vehicle.
BusLine built_in_line();

}  // namespace canvoy::bus
