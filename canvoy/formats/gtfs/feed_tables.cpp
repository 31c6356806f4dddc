#include "canvoy/formats/gtfs/feed_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/formats/plain_text.hpp"

namespace canvoy::gtfs {

namespace {

using host::Error;
using host::Result;
using std::string_view;

constexpr std::uint32_t number_max = 0xFFFF'FFFF;
constexpr double distance_max = 1e9;
constexpr std::uint32_t day_s = 24 * 3600;
/// Longer than any real id; each id is kept.
constexpr std::size_t id_bytes_max = 1024;

/// An id, which is required.
std::string id_of(Table& table, std::size_t column) {
  const string_view id = table.needed(column);
  table.check_utf8(column);
  if (id.size() > id_bytes_max) table.fail(column, "longer than 1024 bytes");
  return std::string(id.substr(0, id_bytes_max));
}

/// 0, 0 is in the Gulf of Guinea, without buses, and so are the poles: feeds write them for a
/// missing position.
void check_place(Table& table, std::size_t latitude, std::size_t longitude) {
  constexpr double pole = 90;
  const std::optional<double> north = parse_number(table.text(latitude));
  const bool is_at_pole = north && std::abs(*north) > pole - 1 && std::abs(*north) <= pole;
  if (is_at_pole) table.fail(latitude, "at a pole: the place of the stop is missing");
  const bool is_nowhere = north == 0.0 && parse_number(table.text(longitude)) == 0.0;
  if (is_nowhere) table.fail(latitude, "0, and stop_lon 0 too: the place of the stop is missing");
}

Exchange exchange_of(Table& table, std::size_t column) {
  return static_cast<Exchange>(table.count(column, 3).value_or(0));
}

}  // namespace

Result<Table> FeedTables::open_needed(string_view name,
                                      std::span<const string_view> columns) const {
  Result<Table> table = Table::open(*archive_, name, columns);
  if (table && !table->is_there()) {
    return Error{archive_->name() + "/" + std::string(name), "missing", "a GTFS feed has it"};
  }
  return table;
}

Result<void> FeedTables::done(const Table& table) const {
  if (const auto& error = table.error(); error) return *error;
  return {};
}

std::size_t FeedTables::find(const Places& places, string_view id) {
  const auto found = places.find(id);
  return found == places.end() ? none : found->second;
}

Result<std::vector<Route>> read_routes(const FeedArchive& archive) {
  enum : std::size_t { id, agency, short_name, long_name, type };
  constexpr static std::array<string_view, 5> columns = {
      "route_id", "agency_id", "route_short_name", "route_long_name", "route_type"};
  Result<Table> table = Table::open(archive, "routes.txt", columns);
  if (!table) return table.error();
  if (!table->is_there()) {
    return Error{archive.name() + "/routes.txt", "missing", "a GTFS feed has it"};
  }
  std::vector<Route> routes;
  std::set<std::string, std::less<>> ids;
  while (table->next()) {
    if (routes.size() == routes_max) table->fail_file("too many routes");
    if (!ids.emplace(table->text(id)).second) table->fail(id, "it is there twice");
    routes.push_back({.id = id_of(*table, id),
                      .agency = std::string(table->text(agency)),
                      .short_name = table->shown(short_name),
                      .long_name = table->shown(long_name),
                      .type = table->count(type, 9999).value_or(3)});
  }
  if (const auto& error = table->error(); error) return *error;
  return routes;
}

Result<void> FeedTables::read_agency() {
  enum : std::size_t { id, name, timezone, language };
  constexpr static std::array<string_view, 4> columns = {"agency_id", "agency_name",
                                                         "agency_timezone", "agency_lang"};
  Result<Table> table = open_needed("agency.txt", columns);
  if (!table) return table.error();
  bool is_first = true;
  while (table->next()) {
    if (is_first || table->text(id) == feed.route.agency) {
      feed.agency = {.id = std::string(table->text(id)),
                     .name = table->shown(name),
                     .timezone = table->shown(timezone),
                     .language = table->shown(language)};
      is_first = false;
    }
  }
  return done(*table);
}

Result<void> FeedTables::read_info() {
  enum : std::size_t { publisher, language, version, start, end };
  constexpr static std::array<string_view, 5> columns = {
      "feed_publisher_name", "feed_lang", "feed_version", "feed_start_date", "feed_end_date"};
  Result<Table> table = Table::open(*archive_, "feed_info.txt", columns);
  if (!table) return table.error();
  if (table->next()) {
    feed.info = {.publisher = table->shown(publisher),
                 .language = table->shown(language),
                 .version = table->shown(version),
                 .start = table->date(start),
                 .end = table->date(end)};
  }
  return done(*table);
}

namespace trip_column {
enum : std::size_t { route, service, id, headsign, short_name, direction, block, shape };
constexpr std::array<string_view, 8> names = {"route_id",      "service_id",      "trip_id",
                                              "trip_headsign", "trip_short_name", "direction_id",
                                              "block_id",      "shape_id"};
}  // namespace trip_column

void FeedTables::read_trip(Table& table, std::size_t other_route) {
  namespace column = trip_column;
  if (feed.trips.size() == trips_max) return table.fail_file("too many trips of one route");
  Trip trip{.id = id_of(table, column::id),
            .other_route = other_route,
            .service = id_of(table, column::service),
            .headsign = table.shown(column::headsign),
            .short_name = table.shown(column::short_name),
            .block = std::string(table.text(column::block))};
  if (const std::optional<std::uint32_t> direction = table.count(column::direction, 1)) {
    trip.direction = static_cast<std::uint8_t>(*direction);
  }
  if (const string_view shape = table.text(column::shape); !shape.empty()) {
    trip.shape = shapes_.try_emplace(std::string(shape), feed.shapes.size()).first->second;
    if (trip.shape == feed.shapes.size()) feed.shapes.push_back({.id = std::string(shape)});
  }
  if (!trips_.try_emplace(trip.id, feed.trips.size()).second) {
    table.fail(column::id, "'" + formats::plain_text(trip.id) + "' is there twice");
  }
  if (services_.try_emplace(trip.service, feed.services.size()).second) {
    feed.services.push_back({.id = trip.service});
  }
  feed.trips.push_back(std::move(trip));
}

Result<void> FeedTables::read_trips() {
  Result<Table> table = open_needed("trips.txt", trip_column::names);
  if (!table) return table.error();
  while (table->next()) {
    if (table->needed(trip_column::route) == feed.route.id) read_trip(*table, none);
  }
  return done(*table);
}

Result<void> FeedTables::read_trips_of_blocks(const std::vector<Route>& routes) {
  std::unordered_set<std::string> blocks;
  for (const Trip& trip : feed.trips) {
    if (!trip.block.empty()) blocks.insert(trip.block);
  }
  if (blocks.empty()) return {};
  Result<Table> table = open_needed("trips.txt", trip_column::names);
  if (!table) return table.error();
  std::unordered_map<std::string, std::size_t> used;
  while (table->next()) {
    const std::string id(table->text(trip_column::route));
    if (id == feed.route.id || !blocks.contains(std::string(table->text(trip_column::block)))) {
      continue;
    }
    const auto route = std::ranges::find(routes, id, &Route::id);
    if (route == routes.end()) continue;
    const auto [place, is_new] = used.try_emplace(id, feed.other_routes.size());
    if (is_new) feed.other_routes.push_back(*route);
    read_trip(*table, place->second);
  }
  return done(*table);
}

namespace call_column {
enum : std::size_t {
  trip,
  arrival,
  departure,
  stop,
  sequence,
  headsign,
  boarding,
  alighting,
  distance,
  timing_point,
  group,
  area,
  window
};
constexpr std::array<string_view, 13> names = {"trip_id",
                                               "arrival_time",
                                               "departure_time",
                                               "stop_id",
                                               "stop_sequence",
                                               "stop_headsign",
                                               "pickup_type",
                                               "drop_off_type",
                                               "shape_dist_traveled",
                                               "timepoint",
                                               "location_group_id",
                                               "location_id",
                                               "start_pickup_drop_off_window"};
}  // namespace call_column

/// GTFS-Flex: an area or a group of stops, which a vehicle visits on demand within a time window.
bool is_area(const Table& table) {
  namespace column = call_column;
  const bool has_area = !table.text(column::group).empty() || !table.text(column::area).empty();
  return !table.text(column::window).empty() || (has_area && table.text(column::stop).empty());
}

Call FeedTables::read_call(Table& table) {
  namespace column = call_column;
  Call call{.arrival = table.time(column::arrival),
            .departure = table.time(column::departure),
            .shape_distance = table.number(column::distance, 0, distance_max),
            .line = static_cast<std::uint32_t>(std::min<std::size_t>(table.line(), number_max)),
            .boarding = exchange_of(table, column::boarding),
            .alighting = exchange_of(table, column::alighting),
            .is_timing_point = table.count(column::timing_point, 1).value_or(1) == 1,
            .headsign = table.shown(column::headsign)};
  if (!call.arrival) call.arrival = call.departure;
  if (!call.departure) call.departure = call.arrival;
  if (!call.arrival) call.is_timing_point = false;
  table.needed(column::sequence);
  call.sequence = table.count(column::sequence, number_max).value_or(0);
  const std::string stop = id_of(table, column::stop);
  call.stop = stops_.try_emplace(stop, feed.stops.size()).first->second;
  if (call.stop == feed.stops.size()) {
    feed.stops.push_back({.id = stop});
    stop_lines_.push_back(table.line());
  }
  return call;
}

Result<void> FeedTables::read_calls() {
  Result<Table> table = open_needed("stop_times.txt", call_column::names);
  if (!table) return table.error();
  std::size_t count = 0;
  // The calls of a trip are usually adjacent.
  std::string last_id;
  std::size_t last = none;
  while (table->next()) {
    const string_view id = table->needed(call_column::trip);
    if (id != last_id) {
      last_id = id;
      last = find(trips_, id);
    }
    if (last == none) continue;
    if (is_area(*table)) {
      skip_area(*table);
      continue;
    }
    if (++count > calls_max) table->fail_file("too many stop times of one route");
    feed.trips[last].calls.push_back(read_call(*table));
  }
  if (const auto& error = table->error(); error) return *error;
  note_areas();
  return check_calls();
}

void FeedTables::skip_area(const Table& table) {
  if (areas_++ == 0) first_area_line_ = table.line();
}

void FeedTables::note_areas() {
  if (areas_ == 0) return;
  feed.notes.push_back(fmt::format(
      "{}/stop_times.txt line {}: {} of the route on demand, without a stop and its "
      "times (GTFS-Flex): left out",
      archive_->name(), first_area_line_,
      areas_ == 1 ? std::string("a row") : fmt::format("the first of {} rows", areas_)));
}

Result<void> FeedTables::check_calls() {
  for (Trip& trip : feed.trips) {
    std::stable_sort(trip.calls.begin(), trip.calls.end(),
                     [](const Call& a, const Call& b) { return a.sequence < b.sequence; });
    if (Result<void> checked = check_trip(trip); !checked) return checked;
  }
  return {};
}

/// Checks that sequences increase, times do not decrease, and both ends have times.
Result<void> FeedTables::check_trip(Trip& trip) const {
  const auto wrong = [&](const Call& call, string_view what) {
    return Error{fmt::format("{}/stop_times.txt line {}", archive_->name(), call.line),
                 std::string(what),
                 {}};
  };
  TimeOfDay before{};
  for (std::size_t i = 0; i < trip.calls.size(); ++i) {
    const Call& call = trip.calls[i];
    if (i > 0 && trip.calls[i - 1].sequence == call.sequence) {
      return wrong(call, "stop_sequence: the trip has it twice");
    }
    const bool is_end = i == 0 || i + 1 == trip.calls.size();
    if (!call.arrival) {
      if (is_end) return wrong(call, "arrival_time: the ends of a trip must have one");
      continue;
    }
    if (*call.arrival < before) return wrong(call, "arrival_time: before the stop before it");
    if (*call.departure < *call.arrival) return wrong(call, "departure_time: before the arrival");
    before = *call.departure;
  }
  return {};
}

Result<void> FeedTables::read_stops() {
  enum : std::size_t { id, code, name, latitude, longitude, zone };
  constexpr static std::array<string_view, 6> columns = {"stop_id",  "stop_code", "stop_name",
                                                         "stop_lat", "stop_lon",  "zone_id"};
  Result<Table> table = open_needed("stops.txt", columns);
  if (!table) return table.error();
  std::vector<bool> is_known(feed.stops.size());
  while (table->next()) {
    const std::size_t place = find(stops_, table->needed(id));
    if (place == none) continue;
    if (is_known[place]) table->fail(id, "it is there twice");
    is_known[place] = true;
    table->needed(latitude);
    table->needed(longitude);
    check_place(*table, latitude, longitude);
    Stop& stop = feed.stops[place];
    stop.code = table->shown(code);
    stop.name = table->shown(name);
    stop.zone = std::string(table->text(zone));
    stop.latitude = table->number(latitude, -90, 90).value_or(0);
    stop.longitude = table->number(longitude, -180, 180).value_or(0);
  }
  if (const auto& error = table->error(); error) return *error;
  return check_stops(is_known);
}

Result<void> FeedTables::check_stops(const std::vector<bool>& is_known) const {
  const auto missing = std::find(is_known.begin(), is_known.end(), false);
  if (missing == is_known.end()) return {};
  const auto place = static_cast<std::size_t>(missing - is_known.begin());
  return Error{
      fmt::format("{}/stop_times.txt line {}", archive_->name(), stop_lines_[place]),
      fmt::format("stop_id: stops.txt has no '{}'", formats::plain_text(feed.stops[place].id)),
      {}};
}

// The optional files: days of operation, frequencies, and shapes.

Result<void> FeedTables::read_services() {
  bool has_calendar = false;
  bool has_dates = false;
  if (Result<void> read = read_calendar(has_calendar); !read) return read;
  if (Result<void> read = read_calendar_dates(has_dates); !read) return read;
  if (has_calendar || has_dates) return {};
  return Error{archive_->name() + "/calendar.txt", "missing, and calendar_dates.txt as well",
               "a GTFS feed has one of them"};
}

Result<void> FeedTables::read_calendar(bool& is_there) {
  enum : std::size_t { id, monday, start = 8, end };
  constexpr static std::array<std::string_view, 10> columns = {
      "service_id", "monday",   "tuesday", "wednesday",  "thursday",
      "friday",     "saturday", "sunday",  "start_date", "end_date"};
  Result<Table> table = Table::open(*archive_, "calendar.txt", columns);
  if (!table) return table.error();
  is_there = table->is_there();
  while (table->next()) {
    const std::size_t place = find(services_, table->needed(id));
    if (place == none) continue;
    Service& service = feed.services[place];
    if (service.start) table->fail(id, "it is there twice");
    for (std::size_t day = 0; day < 7; ++day) {
      table->needed(monday + day);
      const std::uint32_t runs = table->count(monday + day, 1).value_or(0);
      service.weekdays = static_cast<std::uint8_t>(service.weekdays | runs << day);
    }
    table->needed(start);
    table->needed(end);
    service.start = table->date(start);
    service.end = table->date(end);
  }
  return done(*table);
}

Result<void> FeedTables::read_calendar_dates(bool& is_there) {
  enum : std::size_t { id, date, type };
  constexpr static std::array<std::string_view, 3> columns = {"service_id", "date",
                                                              "exception_type"};
  Result<Table> table = Table::open(*archive_, "calendar_dates.txt", columns);
  if (!table) return table.error();
  is_there = table->is_there();
  std::size_t count = 0;
  while (table->next()) {
    const std::size_t place = find(services_, table->needed(id));
    if (place == none) continue;
    if (++count > exceptions_max) table->fail_file("too many exceptions of one route");
    table->needed(date);
    const std::optional<Date> day = table->date(date);
    const std::uint32_t kind = table->count(type, 2).value_or(0);
    if (kind == 0) table->fail(type, "neither 1 (added) nor 2 (removed)");
    if (!day) continue;
    Service& service = feed.services[place];
    (kind == 1 ? service.added : service.removed).push_back(*day);
  }
  return done(*table);
}

Result<void> FeedTables::read_frequencies() {
  enum : std::size_t { trip, start, end, headway };
  constexpr static std::array<std::string_view, 4> columns = {"trip_id", "start_time", "end_time",
                                                              "headway_secs"};
  Result<Table> table = Table::open(*archive_, "frequencies.txt", columns);
  if (!table) return table.error();
  std::size_t count = 0;
  while (table->next()) {
    const std::size_t place = find(trips_, table->needed(trip));
    if (place == none) continue;
    if (++count > trips_max) table->fail_file("too many frequencies of one route");
    table->needed(start);
    table->needed(end);
    Frequency frequency{.start = table->time(start).value_or(TimeOfDay{}),
                        .end = table->time(end).value_or(TimeOfDay{}),
                        .headway = std::chrono::seconds(table->count(headway, day_s).value_or(0))};
    if (frequency.headway.count() == 0) table->fail(headway, "0 or empty");
    if (frequency.end < frequency.start) table->fail(end, "before start_time");
    feed.trips[place].frequencies.push_back(frequency);
  }
  return done(*table);
}

Result<void> FeedTables::read_shapes() {
  enum : std::size_t { id, latitude, longitude, sequence, distance };
  constexpr static std::array<std::string_view, 5> columns = {
      "shape_id", "shape_pt_lat", "shape_pt_lon", "shape_pt_sequence", "shape_dist_traveled"};
  Result<Table> table = Table::open(*archive_, "shapes.txt", columns);
  if (!table) return table.error();
  std::size_t count = 0;
  while (table->next()) {
    const std::size_t place = find(shapes_, table->needed(id));
    if (place == none) continue;
    if (++count > shape_points_max) table->fail_file("too many points of the shapes of one route");
    for (const std::size_t column : {latitude, longitude, sequence}) table->needed(column);
    feed.shapes[place].points.push_back(
        {.latitude = table->number(latitude, -90, 90).value_or(0),
         .longitude = table->number(longitude, -180, 180).value_or(0),
         .distance = table->number(distance, 0, distance_max),
         .sequence = table->count(sequence, number_max).value_or(0)});
  }
  if (table->error()) return *table->error();
  for (Shape& shape : feed.shapes) {
    std::stable_sort(
        shape.points.begin(), shape.points.end(),
        [](const ShapePoint& a, const ShapePoint& b) { return a.sequence < b.sequence; });
  }
  return {};
}

}  // namespace canvoy::gtfs
