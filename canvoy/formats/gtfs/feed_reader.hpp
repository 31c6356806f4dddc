// Reads a GTFS feed from a folder or a zip archive. Keeps the requested route of a feed with all
// trips of a city.
//
//     host::Result<Feed> feed = read_feed("feed.zip", "42");
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

/// Maximum number of trips kept; a feed with more for one route is refused.
inline constexpr std::size_t trips_max = 200'000;
inline constexpr std::size_t calls_max = 4'000'000;         ///< stop times of them
inline constexpr std::size_t shape_points_max = 4'000'000;  ///< points of all shapes
inline constexpr std::size_t routes_max = 1'000'000;        ///< routes in a file
inline constexpr std::size_t exceptions_max = 4'000'000;    ///< rows of calendar_dates.txt

/// Reads the routes in the order of the file.
host::Result<std::vector<Route>> read_routes(const FeedArchive& archive);

/// Reads the route with this id, or else the only route with this short name; if `route` is empty,
/// the only route. Required: agency.txt, stops.txt, routes.txt, trips.txt, stop_times.txt and one
/// of calendar.txt and calendar_dates.txt. Optional: shapes.txt, frequencies.txt and feed_info.txt.
/// Errors: file and line of the first error.
host::Result<Feed> read_feed(const FeedArchive& archive, std::string_view route);
/// Like the above, for a folder or a zip archive.
host::Result<Feed> read_feed(const std::string& path, std::string_view route);

}  // namespace canvoy::gtfs
