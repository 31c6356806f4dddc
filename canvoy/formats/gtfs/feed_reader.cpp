#include "canvoy/formats/gtfs/feed_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "canvoy/formats/gtfs/feed_tables.hpp"
#include "canvoy/formats/plain_text.hpp"

namespace canvoy::gtfs {

namespace {

using host::Error;
using host::Result;

constexpr std::size_t routes_shown = 8;

/// In the form that a user would type.
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

Result<Route> chosen(const FeedArchive& archive, const std::vector<Route>& all,
                     std::string_view wanted) {
  std::vector<Route> fitting;
  for (const Route& route : all) {
    if (route.id == wanted && !wanted.empty()) return route;
    if (wanted.empty() || route.short_name == wanted) fitting.push_back(route);
  }
  if (fitting.size() == 1) return fitting.front();
  const std::string where = archive.name() + "/routes.txt";
  if (all.empty()) return Error{where, "no routes", {}};
  if (wanted.empty()) return Error{where, "several routes", "choose one: " + some_of(all)};
  const std::string shown = formats::plain_text(wanted);
  if (fitting.empty()) {
    return Error{where, fmt::format("no route '{}'", shown), "there are " + some_of(all)};
  }
  return Error{where, fmt::format("several routes are called '{}'", shown),
               "choose one by its id: " + some_of(fitting)};
}

}  // namespace

Result<Feed> read_feed(const FeedArchive& archive, std::string_view route) {
  Result<std::vector<Route>> routes = read_routes(archive);
  if (!routes) return routes.error();
  Result<Route> own = chosen(archive, *routes, route);
  if (!own) return own.error();
  FeedTables tables(archive);
  tables.feed.route = *std::move(own);
  using Step = Result<void> (FeedTables::*)();
  constexpr std::array<Step, 3> first_steps = {&FeedTables::read_agency, &FeedTables::read_info,
                                               &FeedTables::read_trips};
  constexpr std::array<Step, 5> last_steps = {
      &FeedTables::read_calls, &FeedTables::read_stops, &FeedTables::read_services,
      &FeedTables::read_frequencies, &FeedTables::read_shapes};
  for (const Step step : first_steps) {
    if (const Result<void> done = (tables.*step)(); !done) return done.error();
  }
  if (const Result<void> done = tables.read_trips_of_blocks(*routes); !done) return done.error();
  for (const Step step : last_steps) {
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
