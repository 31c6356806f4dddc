// The bus line of a GTFS feed on a day: its trips as journeys in blocks, its stops on their ways.
//
//     LineOfFeed made = line_of_feed(feed, std::chrono::year(2026) / 11 / 23);
//     if (!made.problem.empty()) ...     // no trips on that day
//
// Trips with one block_id are one block. Those without are joined: a vehicle goes on with the next
// trip that begins near where it stands.
#pragma once

#include <string>

#include "canvoy/formats/gtfs/feed.hpp"
#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

struct LineOfFeed {
  BusLine line{};
  std::string problem{};  ///< why there is no line; empty: there is one
};

/// Journeys that frequencies.txt repeats in all are bounded by this.
inline constexpr std::size_t journeys_max = 100'000;

LineOfFeed line_of_feed(const gtfs::Feed& feed, const gtfs::Date& date);

}  // namespace canvoy::bus
