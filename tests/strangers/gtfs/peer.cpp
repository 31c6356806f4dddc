// What our reader takes from a feed, as JSON for others to compare; and a realtime feed for others
// to read.
//
//     canvoy_gtfs_peer feed PATH ROUTE YYYYMMDD COUNT    // with the trips of COUNT days
//     canvoy_gtfs_peer realtime
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/formats/gtfs/realtime.hpp"
#include "canvoy/formats/gtfs/table.hpp"

namespace {

using namespace canvoy::gtfs;
using nlohmann::json;

json seconds(const std::optional<TimeOfDay>& time) {
  return time ? json(time->count()) : json();
}

json trip_of(const Feed& feed, const Trip& trip) {
  json calls = json::array();
  for (const Call& call : trip.calls) {
    calls.push_back({{"stop", feed.stops[call.stop].id},
                     {"sequence", call.sequence},
                     {"arrival", seconds(call.arrival)},
                     {"departure", seconds(call.departure)}});
  }
  json frequencies = json::array();
  for (const Frequency& each : trip.frequencies) {
    frequencies.push_back({each.start.count(), each.end.count(), each.headway.count()});
  }
  json shape = json::array();
  if (trip.shape != none) {
    for (const ShapePoint& point : feed.shapes[trip.shape].points) {
      shape.push_back({point.latitude, point.longitude, point.distance.value_or(-1)});
    }
  }
  return {{"id", trip.id},  {"headsign", trip.headsign},  {"service", trip.service},
          {"calls", calls}, {"frequencies", frequencies}, {"shape", shape}};
}

int tell(const Feed& feed, const Date& first, int days) {
  json stops = json::array();
  for (const Stop& stop : feed.stops) {
    stops.push_back({{"id", stop.id},
                     {"code", stop.code},
                     {"name", stop.name},
                     {"at", {stop.latitude, stop.longitude}}});
  }
  json trips = json::array();
  for (const Trip& trip : feed.trips) trips.push_back(trip_of(feed, trip));
  json running = json::array();
  for (int i = 0; i < days; ++i) {
    const Date date = std::chrono::sys_days(first) + std::chrono::days(i);
    json of_day = json::array();
    for (const Trip& trip : feed.trips) {
      if (feed.runs_on(trip, date)) of_day.push_back(trip.id);
    }
    running.push_back(of_day);
  }
  const json all = {{"agency", feed.agency.name},
                    {"route", feed.route.name()},
                    {"version", feed.info.version},
                    {"stops", stops},
                    {"trips", trips},
                    {"running", running}};
  std::puts(all.dump().c_str());
  return 0;
}

RealtimeFeed sample() {
  using std::chrono::hours;
  using std::chrono::minutes;
  const TripReference trip{.trip = "t1",
                           .route = "42",
                           .direction = 1,
                           .start_date = std::chrono::year(2026) / 11 / 23,
                           .start_time = hours(24) + minutes(5)};
  RealtimeFeed feed{.timestamp = 1'795'449'600};
  feed.vehicles = {{.vehicle = {.id = "bus-7", .label = "7"},
                    .trip = trip,
                    .latitude = 50.125,
                    .longitude = -8.5,
                    .bearing = 270,
                    .odometer_m = 123'456.75,
                    .speed_m_s = 12.5,
                    .stop_sequence = 300,
                    .stop = "m\xC3\xBChle",
                    .status = StopStatus::in_transit_to,
                    .occupancy = Occupancy::standing_room,
                    .occupancy_percent = 180,
                    .timestamp = 1'795'449'599},
                   {.vehicle = {.id = "bus-8"}, .latitude = 0, .longitude = 0}};
  feed.trips = {
      {.trip = trip,
       .vehicle = {.id = "bus-7", .label = "7"},
       .stops = {{.sequence = 2, .stop = "a", .departure_delay_s = -30},
                 {.sequence = 5, .stop = "b", .arrival_delay_s = 125, .departure_delay_s = 0},
                 {.sequence = 6, .stop = "c", .is_skipped = true}},
       .delay_s = -30,
       .timestamp = 1'795'449'598}};
  return feed;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::string_view(arguments[1]) == "realtime") {
    const std::string bytes = realtime_bytes(sample());
    return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() ? 0 : 1;
  }
  if (count != 6) return 2;
  const std::optional<Date> first = parse_date(arguments[4]);
  const auto feed = read_feed(arguments[2], arguments[3]);
  if (!feed) {
    std::fprintf(stderr, "%s\n", feed.error().line().c_str());
    return 1;
  }
  return first ? tell(*feed, *first, std::atoi(arguments[5])) : 2;
}
