#include "canvoy/formats/gtfs/feed_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/formats/gtfs/feed_tables.hpp"
#include "canvoy/formats/plain_text.hpp"

namespace canvoy::gtfs {

namespace {

using host::Error;
using host::Result;

constexpr std::size_t routes_shown = 8;

/// As the user would say them.
std::string some_of(const std::vector<Route>& routes) {
  std::string text;
  for (std::size_t i = 0; i < routes.size() && i < routes_shown; ++i) {
    text += (i == 0 ? "" : ", ") + formats::plain_text(routes[i].id);
    if (!routes[i].name().empty()) text += " (" + routes[i].name() + ")";
  }
  if (routes.size() > routes_shown)
    text += fmt::format(" and {} more", routes.size() - routes_shown);
  return text;
}

Result<Route> chosen(const FeedArchive& archive, std::string_view wanted) {
  Result<std::vector<Route>> all = read_routes(archive);
  if (!all) return all.error();
  std::vector<Route> fitting;
  for (const Route& route : *all) {
    if (route.id == wanted && !wanted.empty()) return route;
    if (wanted.empty() || route.short_name == wanted) fitting.push_back(route);
  }
  if (fitting.size() == 1) return fitting.front();
  const std::string where = archive.name() + "/routes.txt";
  if (all->empty()) return Error{where, "no routes", {}};
  if (wanted.empty()) return Error{where, "several routes", "choose one: " + some_of(*all)};
  const std::string shown = formats::plain_text(wanted);
  if (fitting.empty()) {
    return Error{where, fmt::format("no route '{}'", shown), "there are " + some_of(*all)};
  }
  return Error{where, fmt::format("several routes are called '{}'", shown),
               "choose one by its id: " + some_of(fitting)};
}

}  // namespace

Result<Feed> read_feed(const FeedArchive& archive, std::string_view route) {
  Result<Route> own = chosen(archive, route);
  if (!own) return own.error();
  FeedTables tables(archive);
  tables.feed.route = *std::move(own);
  using Step = Result<void> (FeedTables::*)();
  constexpr std::array<Step, 8> steps = {
      &FeedTables::read_agency,      &FeedTables::read_info,   &FeedTables::read_trips,
      &FeedTables::read_calls,       &FeedTables::read_stops,  &FeedTables::read_services,
      &FeedTables::read_frequencies, &FeedTables::read_shapes,
  };
  for (const Step step : steps) {
    if (const Result<void> done = (tables.*step)(); !done) return done.error();
  }
  return std::move(tables.feed);
}

Result<Feed> read_feed(const std::string& path, std::string_view route) {
  const Result<FeedArchive> archive = FeedArchive::open(path);
  if (!archive) return archive.error();
  return read_feed(*archive, route);
}

}  // namespace canvoy::gtfs
