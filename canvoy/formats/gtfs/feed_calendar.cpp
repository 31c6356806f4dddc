// The optional files: on which days trips run, how often, and along which way.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/formats/gtfs/feed_tables.hpp"

namespace canvoy::gtfs {

namespace {

using CalendarResult = host::Result<void>;
constexpr std::uint32_t sequence_max = 0xFFFF'FFFF;
constexpr double shape_distance_max = 1e9;
constexpr std::uint32_t day_s = 24 * 3600;

}  // namespace

CalendarResult FeedTables::read_services() {
  bool has_calendar = false;
  bool has_dates = false;
  if (CalendarResult read = read_calendar(has_calendar); !read) return read;
  if (CalendarResult read = read_calendar_dates(has_dates); !read) return read;
  if (has_calendar || has_dates) return {};
  return host::Error{archive_->name() + "/calendar.txt", "missing, and calendar_dates.txt as well",
                     "a GTFS feed has one of them"};
}

CalendarResult FeedTables::read_calendar(bool& is_there) {
  enum : std::size_t { id, monday, start = 8, end };
  constexpr static std::array<std::string_view, 10> columns = {
      "service_id", "monday",   "tuesday", "wednesday",  "thursday",
      "friday",     "saturday", "sunday",  "start_date", "end_date"};
  host::Result<Table> table = Table::open(*archive_, "calendar.txt", columns);
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

CalendarResult FeedTables::read_calendar_dates(bool& is_there) {
  enum : std::size_t { id, date, type };
  constexpr static std::array<std::string_view, 3> columns = {"service_id", "date",
                                                              "exception_type"};
  host::Result<Table> table = Table::open(*archive_, "calendar_dates.txt", columns);
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

CalendarResult FeedTables::read_frequencies() {
  enum : std::size_t { trip, start, end, headway };
  constexpr static std::array<std::string_view, 4> columns = {"trip_id", "start_time", "end_time",
                                                              "headway_secs"};
  host::Result<Table> table = Table::open(*archive_, "frequencies.txt", columns);
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

CalendarResult FeedTables::read_shapes() {
  enum : std::size_t { id, latitude, longitude, sequence, distance };
  constexpr static std::array<std::string_view, 5> columns = {
      "shape_id", "shape_pt_lat", "shape_pt_lon", "shape_pt_sequence", "shape_dist_traveled"};
  host::Result<Table> table = Table::open(*archive_, "shapes.txt", columns);
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
         .distance = table->number(distance, 0, shape_distance_max),
         .sequence = table->count(sequence, sequence_max).value_or(0)});
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
