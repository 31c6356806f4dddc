// The files of a GTFS feed one after the other, into the Feed of one route: each takes of its file
// what those before it have asked for.
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
  explicit FeedTables(const FeedArchive& archive) : archive_(&archive) {}

  /// The one of the route, or the first one.
  host::Result<void> read_agency();
  host::Result<void> read_info();
  host::Result<void> read_trips();
  host::Result<void> read_calls();
  host::Result<void> read_stops();
  host::Result<void> read_services();
  host::Result<void> read_frequencies();
  host::Result<void> read_shapes();

  Feed feed{};

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
  /// Where `id` stands, or `none`.
  static std::size_t find(const Places& places, std::string_view id);
  void read_trip(Table& table);
  Call read_call(Table& table);
  host::Result<void> check_calls();
  host::Result<void> check_trip(Trip& trip) const;
  host::Result<void> check_stops(const std::vector<bool>& is_known) const;
  host::Result<void> read_calendar(bool& is_there);
  host::Result<void> read_calendar_dates(bool& is_there);

  const FeedArchive* archive_;
  Places trips_;
  Places stops_;
  std::vector<std::size_t> stop_lines_;  ///< of stop_times.txt, where each was asked for first
  Places services_;
  Places shapes_;
};

}  // namespace canvoy::gtfs
