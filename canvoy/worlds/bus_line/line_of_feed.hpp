// Makes the bus line of a GTFS feed on a day: its trips as journeys in blocks, its stops on their
// paths.
//
//     LineOfFeed made = line_of_feed(feed, std::chrono::year(2026) / 11 / 23);
//     if (!made.problem.empty()) ...     // no trips on that day
//
// Trips with one block_id form a block, with those of other lines that the same vehicle drives
// between them. Trips without one are joined: a vehicle continues with the next trip that begins
// near where it stands.
#pragma once

#include <string>

#include "canvoy/formats/gtfs/feed.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"

namespace canvoy::bus_line {

struct LineOfFeed {
  BusLine line{};         ///< with a block for each vehicle
  std::string problem{};  ///< reason why there is no line; empty: there is one
};

/// Most stops of a route: 610Ah counts no further.
inline constexpr std::size_t route_stops_max = 255;
/// Most journeys that frequencies.txt may repeat in all.
inline constexpr std::size_t journeys_max = 100'000;

/// Reads trips of that day; the feed is not needed afterwards.
LineOfFeed line_of_feed(const gtfs::Feed& feed, const gtfs::Date& date);

}  // namespace canvoy::bus_line
