// Reads the files of a GTFS feed in sequence into the Feed of one route. Each function takes the
// rows that the previous ones need.
//
//     FeedTables tables(archive);
//     tables.feed.route = route;
//     tables.read_trips();    // then calls, stops, services, frequencies, shapes
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "canvoy/can/host/result.hpp"
#include "canvoy/formats/gtfs/feed.hpp"
#include "canvoy/formats/gtfs/feed_archive.hpp"
#include "canvoy/formats/gtfs/table.hpp"

namespace canvoy::gtfs {

class FeedTables {
 public:
  /// Begins without anything read. `archive` must outlive this.
  explicit FeedTables(const FeedArchive& archive) : archive_(&archive) {}

  /// Reads the agency of the route, or the first one.
  host::Result<void> read_agency();
  /// Reads feed_info.txt, if the feed has it.
  host::Result<void> read_info();
  /// Reads the trips of the route.
  host::Result<void> read_trips();
  /// Reads the trips of `routes` that are in a block with a trip of the route.
  host::Result<void> read_trips_of_blocks(const std::vector<Route>& routes);
  /// Reads the calls of the trips.
  host::Result<void> read_calls();
  /// Reads the stops of the calls.
  host::Result<void> read_stops();
  /// Reads the services of the trips.
  host::Result<void> read_services();
  /// Reads frequencies.txt, if the feed has it.
  host::Result<void> read_frequencies();
  /// Reads the shapes of the trips, if the feed has them.
  host::Result<void> read_shapes();

  Feed feed{};  ///< what was read so far

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  using Places = std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>>;

  host::Result<Table> open_needed(std::string_view name,
                                  std::span<const std::string_view> columns) const;
  host::Result<void> done(const Table& table) const;
  /// Position of `id`, or `none`.
  static std::size_t find(const Places& places, std::string_view id);
  void read_trip(Table& table, std::size_t other_route);
  Call read_call(Table& table);
  void skip_area(const Table& table);
  void note_areas();
  host::Result<void> check_calls();
  host::Result<void> check_trip(Trip& trip) const;
  host::Result<void> check_stops(const std::vector<bool>& is_known) const;
  host::Result<void> read_calendar(bool& is_there);
  host::Result<void> read_calendar_dates(bool& is_there);

  const FeedArchive* archive_;
  Places trips_;
  Places stops_;
  std::vector<std::size_t> stop_lines_;  ///< of stop_times.txt, of the first reference to each stop
  std::size_t areas_ = 0;                ///< rows of stop_times.txt without a stop
  std::size_t first_area_line_ = 0;
  Places services_;
  Places shapes_;
};

}  // namespace canvoy::gtfs
