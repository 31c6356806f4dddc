// Common parts of the tests of odd timetables: a town of three stops, changes of its files, and
// what is driven by them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/line_of_feed.hpp"

namespace canvoy::tools::feed_oddities_test {

using namespace std::chrono_literals;
using Texts = std::map<std::string, std::string, std::less<>>;

inline constexpr gtfs::Date monday = std::chrono::year(2026) / 11 / 23;
inline const std::string times_head = "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n";
inline const std::string stops_head = "stop_id,stop_name,stop_lat,stop_lon\n";
inline const std::string trips_head =
    "route_id,service_id,trip_id,trip_headsign,direction_id,block_id,shape_id\n";
inline const std::string days_head =
    "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n";

/// One line of three stops in a row, about 1.3 km apart, and one trip.
inline Texts town() {
  return {
      {"agency.txt",
       "agency_id,agency_name,agency_url,agency_timezone\nT,Town,https://t.example,Europe/"
       "Berlin\n"},
      {"stops.txt", stops_head + "a,Market,50.1,8.5\nb,School,50.11,8.51\nc,Harbour,50.12,8.52\n"},
      {"routes.txt",
       "route_id,agency_id,route_short_name,route_long_name,route_type\nr1,T,42,Town line,3\n"},
      {"trips.txt", trips_head + "r1,week,t1,Pier,0,,\n"},
      {"stop_times.txt",
       times_head + "t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3\n"},
      {"calendar.txt", days_head + "week,1,1,1,1,1,0,0,20261101,20261231\n"},
  };
}

/// Changes of the town.
struct Change {
  std::string file;
  std::string text;
  bool is_more = false;  ///< appended
};
inline Change with(std::string file, std::string text) {
  return {std::move(file), std::move(text)};
}
inline Change plus(std::string file, std::string text) {
  return {std::move(file), std::move(text), true};
}
inline Change times(const std::string& rows) {
  return with("stop_times.txt", times_head + rows);
}
inline Change trips(const std::string& rows) {
  return with("trips.txt", trips_head + rows);
}
inline Change stop(const std::string& row) {
  return with("stops.txt", stops_head + row + "b,School,50.11,8.51\nc,Harbour,50.12,8.52\n");
}

struct Oddity {
  const char* what;
  std::vector<Change> changes;
  std::string right;
};

/// `8:05`, `8:05:30`.
inline std::string time_text(Duration time) {
  const auto s = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  char text[32];
  std::snprintf(text, sizeof text, s % 60 == 0 ? "%d:%02d" : "%d:%02d:%02d", int(s / 3600),
                int(s / 60 % 60), int(s % 60));
  return text;
}

/// `42 a 8:00 b 8:05-8:07 > Pier`: its line, the stops with their times, and the destination from
/// each on.
inline std::string text_of(const bus_line::BusLine& line, const bus_line::Journey& journey) {
  const bus_line::BusRoute& route = line.routes[journey.route];
  std::string text = line.names_of(route).name;
  std::string destination;
  for (std::size_t i = 0; i < journey.passings.size(); ++i) {
    const bus_line::Passing& passing = journey.passings[i];
    text += " " + line.stop(journey.route, i).id + " " + time_text(passing.arrival);
    if (passing.departure != passing.arrival) text += "-" + time_text(passing.departure);
    if (route.destination_at(i) == destination) continue;
    destination = route.destination_at(i);
    text += " > " + destination;
  }
  return text;
}

inline Texts texts_of(const Oddity& oddity) {
  Texts texts = town();
  for (const Change& change : oddity.changes) {
    if (change.is_more) {
      texts[change.file] += change.text;
    } else {
      texts[change.file] = change.text;
    }
  }
  return texts;
}

/// One journey per line; `|` begins those of another vehicle; or the reason why there is none.
inline std::string driven(const Oddity& oddity, bus_line::BusLine* line = nullptr) {
  const auto archive = gtfs::FeedArchive::of_texts(texts_of(oddity));
  const host::Result<gtfs::Feed> feed = gtfs::read_feed(archive, "");
  if (!feed) return feed.error().line();
  const bus_line::LineOfFeed made = bus_line::line_of_feed(*feed, monday);
  if (!made.problem.empty()) return made.problem;
  if (line != nullptr) *line = made.line;
  std::string text;
  for (const std::string& note : feed->notes) text += note + " : ";
  for (const bus_line::Block& block : made.line.blocks) {
    if (block.number > 1) text += " | ";
    for (const bus_line::Journey& journey : block.journeys) {
      if (&journey != &block.journeys.front()) text += "; ";
      text += text_of(made.line, journey);
    }
  }
  return text;
}

inline const std::string as_ever = "42 a 8:00 > Pier b 8:05 c 8:10";
inline const std::string no_trip = "no trip of the route runs on this day";

inline void expect_all(const std::vector<Oddity>& oddities) {
  for (const Oddity& oddity : oddities) EXPECT_EQ(driven(oddity), oddity.right) << oddity.what;
}

/// Drives each vehicle of feeds that are not refused to the end of its block; returns their number.
inline std::size_t expect_driven(const std::vector<Oddity>& oddities) {
  std::size_t count = 0;
  for (const Oddity& oddity : oddities) {
    bus_line::BusLine line;
    driven(oddity, &line);
    for (std::size_t block = 0; block < line.blocks.size(); ++block) {
      bus_line::BusVehicle vehicle(line, block, {.seed = ++count});
      const Duration way = 3h;
      while (!vehicle.is_over() && vehicle.deadline() < Time(way)) {
        vehicle.advance(vehicle.deadline());
      }
      EXPECT_TRUE(vehicle.is_over()) << oddity.what;
    }
  }
  return count;
}

}  // namespace canvoy::tools::feed_oddities_test
