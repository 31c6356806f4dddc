// Reads a GTFS feed, from a folder or a zip archive. Of a city's feed with all its trips, the one
// route is kept that is wanted.
//
//     Result<Feed> feed = read_feed("feed.zip", "42");
//     if (!feed) return fail(feed.error().line());   // feed.zip/stops.txt line 7: stop_lat: ...
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/result.hpp"
#include "canvoy/formats/gtfs/feed.hpp"
#include "canvoy/formats/gtfs/feed_archive.hpp"

namespace canvoy::gtfs {

/// What is kept at most; a feed with more for one route is refused.
inline constexpr std::size_t trips_max = 200'000;
inline constexpr std::size_t calls_max = 4'000'000;
inline constexpr std::size_t shape_points_max = 4'000'000;
inline constexpr std::size_t routes_max = 1'000'000;
inline constexpr std::size_t exceptions_max = 4'000'000;

/// The routes in the order of the file.
host::Result<std::vector<Route>> read_routes(const FeedArchive& archive);

/// The route of this id, or else the only one of this short name; where it is empty, the only
/// route there is. agency.txt, stops.txt, routes.txt, trips.txt, stop_times.txt and one of
/// calendar.txt and calendar_dates.txt must be there; shapes.txt, frequencies.txt and feed_info.txt
/// may be. Errors: file and line of the first thing that is wrong.
host::Result<Feed> read_feed(const FeedArchive& archive, std::string_view route);
host::Result<Feed> read_feed(const std::string& path, std::string_view route);

}  // namespace canvoy::gtfs
