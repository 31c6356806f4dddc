// Changes of a timetable for a day, as a dispatcher makes them: journeys without passengers from
// the depot and back to it, journeys that turn short, and detours. All are made before the run: the
// on-board computer has the timetable that the driver drives.
//
//     BusLine line = built_in_line();
//     turn_short(line, 0, {.journey = 3, .stop = "School"});
//     add_depot(line, {.place = {0.008, 0.008}});
//
// Each function returns the reason why the change is not possible, and changes nothing then; empty:
// it is made. Stops are meant by their id or their name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/worlds/bus_line/bus_line.hpp"

namespace canvoy::bus_line {

/// Garage of the vehicles of a line.
struct Depot {
  GeoPoint place{};                     ///< WGS 84
  std::string name = "Depot";           ///< shown as a stop
  std::string sign = "Not in service";  ///< shown as the destination, on the ways out and in
};

/// A journey that ends before its last stop. If the next journey of the block calls at a stop of
/// the same name, it begins there.
struct ShortTurn {
  std::uint32_t journey = 0;  ///< number (6195h) within the block
  std::string stop{};         ///< last stop; neither the first nor the last of the route
};

/// A journey that leaves out stops, which follow each other, on another way.
struct Detour {
  std::uint32_t journey = 0;           ///< number (6195h) within the block
  std::vector<std::string> without{};  ///< one stop or more, not the first, not the last
  std::vector<GeoPoint> via{};         ///< corners of the way; none: straight ahead
};

/// Adds a pull-out journey before the first journey of each block and a pull-in journey after the
/// last one. No passenger gets in or out on them. They have no trip, and numbers above all others.
/// The vehicle arrives at the first stop a minute before its departure.
std::string add_depot(BusLine& line, const Depot& depot);
/// Ends a journey of a block, by its index in BusLine::blocks, at a stop of its route.
std::string turn_short(BusLine& line, std::size_t block, const ShortTurn& change);
/// Leads a journey of a block past stops of its route.
std::string divert(BusLine& line, std::size_t block, const Detour& change);

}  // namespace canvoy::bus_line
