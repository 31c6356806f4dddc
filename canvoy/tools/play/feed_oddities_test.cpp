// Oddities of timetables, each as a small feed: the resulting drive of the bus, or the reason of
// the refusal. Expected results follow from the GTFS Schedule reference (gtfs.org) and the CSV of
// RFC 4180; the kinds are those of the notices of the canonical validator, with their names.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/gtfs/feed_reader.hpp"
#include "canvoy/worlds/bus_line/bus_vehicle.hpp"
#include "canvoy/worlds/bus_line/line_of_feed.hpp"

namespace canvoy::tools::feed_oddities_test {
namespace {

using namespace std::chrono_literals;
using Texts = std::map<std::string, std::string, std::less<>>;

constexpr gtfs::Date monday = std::chrono::year(2026) / 11 / 23;
const std::string times_head = "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n";
const std::string stops_head = "stop_id,stop_name,stop_lat,stop_lon\n";
const std::string trips_head =
    "route_id,service_id,trip_id,trip_headsign,direction_id,block_id,shape_id\n";
const std::string days_head =
    "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n";

/// One line of three stops in a row, about 1.3 km apart, and one trip.
Texts town() {
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
Change with(std::string file, std::string text) {
  return {std::move(file), std::move(text)};
}
Change plus(std::string file, std::string text) {
  return {std::move(file), std::move(text), true};
}
Change times(const std::string& rows) {
  return with("stop_times.txt", times_head + rows);
}
Change trips(const std::string& rows) {
  return with("trips.txt", trips_head + rows);
}
Change stop(const std::string& row) {
  return with("stops.txt", stops_head + row + "b,School,50.11,8.51\nc,Harbour,50.12,8.52\n");
}

struct Oddity {
  const char* what;
  std::vector<Change> changes;
  std::string right;
};

/// `8:05`, `8:05:30`.
std::string time_text(Duration time) {
  const auto s = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  char text[32];
  std::snprintf(text, sizeof text, s % 60 == 0 ? "%d:%02d" : "%d:%02d:%02d", int(s / 3600),
                int(s / 60 % 60), int(s % 60));
  return text;
}

/// `42 a 8:00 b 8:05-8:07 > Pier`: its line, the stops with their times, and the destination from
/// each on.
std::string text_of(const bus_line::BusLine& line, const bus_line::Journey& journey) {
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

Texts texts_of(const Oddity& oddity) {
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
std::string driven(const Oddity& oddity, bus_line::BusLine* line = nullptr) {
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

const std::string as_ever = "42 a 8:00 > Pier b 8:05 c 8:10";
const std::string no_trip = "no trip of the route runs on this day";

/// A row of `count` stops, and a trip that calls at each of them.
std::vector<Change> long_trip(unsigned count) {
  std::string stops = stops_head;
  std::string calls = times_head;
  for (unsigned i = 0; i < count; ++i) {
    char row[96];
    std::snprintf(row, sizeof row, "s%u,Stop %u,%.4f,8.5\n", i, i, 50 + 0.004 * i);
    stops += row;
    std::snprintf(row, sizeof row, "t1,%02u:%02u:00,%02u:%02u:00,s%u,%u\n", 8 + i / 60, i % 60,
                  8 + i / 60, i % 60, i, i);
    calls += row;
  }
  return {with("stops.txt", stops), with("stop_times.txt", calls)};
}

const std::vector<Oddity>& file_oddities() {
  static const std::vector<Oddity> all = {
      {"as it should be", {}, as_ever},
      {"a byte order mark", {with("stops.txt", "\xEF\xBB\xBF" + town()["stops.txt"])}, as_ever},
      {"ends of lines of Windows",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence\r\n"
             "t1,8:00:00,8:00:00,a,1\r\nt1,8:05:00,8:05:00,b,2\r\nt1,8:10:00,8:10:00,c,3\r\n")},
       as_ever},
      {"a last line without its end",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3")},
       as_ever},
      {"empty_row: rows without anything",
       {times("\nt1,8:00:00,8:00:00,a,1\n\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,c,3\n\n")},
       as_ever},
      {"leading_or_trailing_whitespaces",
       {times("t1 , 8:00:00,8:00:00 ,a, 1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,\tc,3\n")},
       as_ever},
      {"names of columns in quotation marks",
       {with("stops.txt",
             "\"stop_id\",\"stop_name\",\"stop_lat\",\"stop_lon\"\n\"a\",A,50.1,8.5\n"
             "b,B,50.11,8.51\nc,C,50.12,8.52\n")},
       as_ever},
      {"unknown_column, and another order",
       {with("stops.txt",
             "stop_lon,mayor,stop_lat,stop_id\n8.5,x,50.1,a\n8.51,,50.11,b\n"
             "8.52,,50.12,c\n")},
       as_ever},
      {"commas at the ends of rows",
       {times("t1,8:00:00,8:00:00,a,1,,\nt1,8:05:00,8:05:00,b,2,\nt1,8:10:00,8:10:00,c,3,\n")},
       as_ever},
      {"unknown_file", {with("mayors.txt", "\x01\x02")}, as_ever},
      {"invalid_row_length: a text with a comma without quotation marks",
       {stop("a,Market, old,50.1,8.5\n")},
       "feed/stops.txt line 2: 5 fields, and 4 columns; is a text with commas without quotation "
       "marks?"},
      {"csv_parsing_failed: a quotation mark that nothing closes",
       {with("stops.txt", stops_head + "a,\"Market,50.1,8.5\n")},
       "feed/stops.txt line 2: the file ends within quotation marks"},
      {"duplicated_column",
       {with("stops.txt", "stop_id,stop_id,stop_lat,stop_lon\na,a,50.1,8.5\n")},
       "feed/stops.txt line 1: stop_id: the column is there twice"},
      {"missing_required_column",
       {with("stops.txt", "stop_id,stop_name,stop_lat\na,A,50.1\n")},
       "feed/stops.txt line 2: stop_lon: the column is missing"},
      {"empty_file",
       {with("trips.txt", "")},
       "feed/trips.txt line 1: empty; the names of its columns are missing"},
      {"a file in UTF-16",
       {with("stops.txt", std::string("\xFF\xFE"
                                      "s\0",
                                      4))},
       "feed/stops.txt line 1: the text is UTF-16; save it as UTF-8"},
  };
  return all;
}

const std::vector<Oddity>& time_oddities() {
  static const std::vector<Oddity> all = {
      {"a trip over midnight",
       {times("t1,23:58:00,23:58:00,a,1\nt1,24:03:00,24:03:00,b,2\nt1,24:08:00,24:08:00,c,3\n")},
       "42 a 23:58 > Pier b 24:03 c 24:08"},
      {"a day of service that begins at night",
       {times("t1,26:00:00,26:00:00,a,1\nt1,26:10:00,26:10:00,c,2\n")},
       "42 a 26:00 > Pier c 26:10"},
      {"stop_time_with_arrival_before_previous_departure_time: midnight as 0:03",
       {times("t1,23:58:00,23:58:00,a,1\nt1,0:03:00,0:03:00,b,2\n")},
       "feed/stop_times.txt line 3: arrival_time: before the stop before it"},
      {"invalid_time: without seconds",
       {times("t1,08:00,08:00,a,1\n")},
       "feed/stop_times.txt line 2: arrival_time: '08:00' is no time as 08:05:00"},
      {"invalid_time: 60 minutes",
       {times("t1,8:60:00,8:60:00,a,1\n")},
       "feed/stop_times.txt line 2: arrival_time: '8:60:00' is no time as 08:05:00"},
      {"missing_trip_edge: the first without a time",
       {times("t1,,,a,1\nt1,8:05:00,8:05:00,b,2\n")},
       "feed/stop_times.txt line 2: arrival_time: the ends of a trip must have one"},
      {"missing_trip_edge: the last without a time",
       {times("t1,8:00:00,8:00:00,a,1\nt1,,,b,2\n")},
       "feed/stop_times.txt line 3: arrival_time: the ends of a trip must have one"},
      {"a stop without a time, halfway between two",
       {times("t1,8:00:00,8:00:00,a,1\nt1,,,b,2\nt1,8:10:00,8:10:00,c,3\n")},
       as_ever},
      {"stop_time_with_only_arrival_or_departure_time",
       {times("t1,,8:00:00,a,1\nt1,8:05:00,,b,2\nt1,8:10:00,,c,3\n")},
       as_ever},
      {"all at the same minute",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:00:00,8:00:00,b,2\nt1,8:00:00,8:00:00,c,3\n")},
       "42 a 8:00 > Pier b 8:00 c 8:00"},
      {"fast_travel_between_consecutive_stops: it is late then",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:00:01,8:00:01,b,2\nt1,8:00:02,8:00:02,c,3\n")},
       "42 a 8:00 > Pier b 8:00:01 c 8:00:02"},
      {"a stop where it stands",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:07:30,b,2\nt1,8:10:00,8:10:00,c,3\n")},
       "42 a 8:00 > Pier b 8:05-8:07:30 c 8:10"},
      {"departure before arrival",
       {times("t1,8:00:00,7:59:00,a,1\n")},
       "feed/stop_times.txt line 2: departure_time: before the arrival"},
      {"rows in any order, sequences with gaps and from 0 on",
       {times("t1,8:10:00,8:10:00,c,70\nt1,8:00:00,8:00:00,a,0\nt1,8:05:00,8:05:00,b,9\n")},
       as_ever},
      {"duplicate_key: a sequence twice",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,1\n")},
       "feed/stop_times.txt line 3: stop_sequence: the trip has it twice"},
      {"number_out_of_range: a sequence below 0",
       {times("t1,8:00:00,8:00:00,a,-1\n")},
       "feed/stop_times.txt line 2: stop_sequence: '-1' is no whole number from 0 to 4294967295"},
      {"frequencies: each 20 minutes, the end not included",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:40:00,1200\n")},
       "42 a 9:00 > Pier b 9:05 c 9:10 | 42 a 9:20 > Pier b 9:25 c 9:30"},
      {"start_and_end_range_equal: frequencies for no time",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:00:00,60\n")},
       no_trip},
      {"start_and_end_range_out_of_order",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,8:00:00,60\n")},
       "feed/frequencies.txt line 2: end_time: before start_time"},
      {"a headway of 0",
       {with("frequencies.txt",
             "trip_id,start_time,end_time,headway_secs\nt1,9:00:00,9:30:00,0\n")},
       "feed/frequencies.txt line 2: headway_secs: 0 or empty"},
  };
  return all;
}

const std::vector<Oddity>& stop_oddities() {
  static const std::vector<Oddity> all = {
      {"the same stop twice in a row: it stands there",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:07:00,8:07:00,b,3\n"
              "t1,8:10:00,8:10:00,c,4\n")},
       "42 a 8:00 > Pier b 8:05-8:07 c 8:10"},
      {"the first one twice",
       {times("t1,7:58:00,7:58:00,a,1\nt1,8:00:00,8:00:00,a,2\nt1,8:10:00,8:10:00,c,3\n")},
       "42 a 7:58-8:00 > Pier c 8:10"},
      {"the last one three times, the second without a time",
       {times(
           "t1,8:00:00,8:00:00,a,1\nt1,8:10:00,8:10:00,c,2\nt1,,,c,3\nt1,8:12:00,8:12:00,c,4\n")},
       "42 a 8:00 > Pier c 8:10-8:12"},
      {"one stop alone, twice",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:10:00,8:10:00,a,2\n")},
       no_trip},
      {"a loop",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,a,3\n")},
       "42 a 8:00 > Pier b 8:05 a 8:10"},
      {"there and back to one stop twice",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,b,2\nt1,8:10:00,8:10:00,a,3\n"
              "t1,8:15:00,8:15:00,b,4\nt1,8:20:00,8:20:00,c,5\n")},
       "42 a 8:00 > Pier b 8:05 a 8:10 b 8:15 c 8:20"},
      {"unusable_trip: one stop", {times("t1,8:00:00,8:00:00,a,1\n")}, no_trip},
      {"unused_trip: no stop", {times("")}, no_trip},
      {"foreign_key_violation: a stop that is not there",
       {times("t1,8:00:00,8:00:00,a,1\nt1,8:05:00,8:05:00,x,2\n")},
       "feed/stop_times.txt line 3: stop_id: stops.txt has no 'x'"},
      {"duplicate_key: a stop twice",
       {plus("stops.txt", "a,Again,50.1,8.5\n")},
       "feed/stops.txt line 5: stop_id: it is there twice"},
      {"stop_without_stop_time: nobody calls there", {plus("stops.txt", "z,Zoo,,\n")}, as_ever},
      {"stops at one place, all of them",
       {with("stops.txt", stops_head + "a,A,50.1,8.5\nb,B,50.1,8.5\nc,C,50.1,8.5\n")},
       "trip 't1' has all of its stops at one place"},
      {"two stops at one place, and a third one elsewhere",
       {with("stops.txt", stops_head + "a,A,50.1,8.5\nb,B,50.1,8.5\nc,C,50.12,8.52\n")},
       as_ever},
      {"point_near_origin",
       {stop("a,Market,0.0,0\n")},
       "feed/stops.txt line 2: stop_lat: 0, and stop_lon 0 too: the place of the stop is missing"},
      {"number_out_of_range: a latitude of 91",
       {stop("a,Market,91,8.5\n")},
       "feed/stops.txt line 2: stop_lat: '91' is no number from -90 to 90"},
      {"invalid_float: a decimal comma",
       {stop("a,Market,\"50,1\",8.5\n")},
       "feed/stops.txt line 2: stop_lat: '50,1' is no number from -90 to 90"},
      {"missing_required_field: no latitude",
       {stop("a,Market,,8.5\n")},
       "feed/stops.txt line 2: stop_lat: empty"},
      {"256 stops", long_trip(256),
       "trip 't1' has 256 stops: CiA 407 counts 255 of a route (610Ah)"},
      {"a shape of one point",
       {trips("r1,week,t1,Pier,0,,s\n"),
        with("shapes.txt", "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence\ns,50,8,1\n")},
       as_ever},
      {"foreign_key_violation: a shape that is not there",
       {trips("r1,week,t1,Pier,0,,s\n")},
       as_ever},
      {"stops_match_shape_out_of_order: a shape the wrong way round",
       {trips("r1,week,t1,Pier,0,,s\n"),
        with("shapes.txt",
             "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence\n"
             "s,50.12,8.52,1\ns,50.1,8.5,2\n")},
       as_ever},
      {"stop_too_far_from_shape: some 100 km",
       {trips("r1,week,t1,Pier,0,,s\n"),
        with("shapes.txt",
             "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence\n"
             "s,51,8.5,1\ns,51.02,8.52,2\n")},
       as_ever},
      {"GTFS-Flex: an area in place of a stop",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,location_id,"
             "start_pickup_drop_off_window,end_pickup_drop_off_window\n"
             "t1,8:00:00,8:00:00,a,1,,,\nt1,,,,2,zone,8:00:00,8:10:00\n"
             "t1,8:05:00,8:05:00,b,3,,,\nt1,8:10:00,8:10:00,c,4,,,\n")},
       "feed/stop_times.txt line 3: a row of the route on demand, without a stop and its times "
       "(GTFS-Flex): left out : " +
           as_ever},
      {"GTFS-Flex: a trip of groups alone",
       {with("stop_times.txt",
             "trip_id,stop_id,stop_sequence,location_group_id,"
             "start_pickup_drop_off_window,end_pickup_drop_off_window\n"
             "t1,,1,g,8:00:00,18:00:00\nt1,,2,g,8:00:00,18:00:00\n")},
       no_trip},
  };
  return all;
}

const std::vector<Oddity>& line_oddities() {
  static const std::string more_times = "t2,8:12:00,8:12:00,c,1\nt2,8:22:00,8:22:00,a,2\n";
  static const std::vector<Oddity> all = {
      {"stop_headsign: from its stop to the next, no further",
       {with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,stop_headsign\n"
             "t1,8:00:00,8:00:00,a,1,Pier via School\nt1,8:05:00,8:05:00,b,2,\n"
             "t1,8:10:00,8:10:00,c,3,Depot\n")},
       "42 a 8:00 > Pier via School b 8:05 > Pier c 8:10"},
      {"stop_headsign alone",
       {trips("r1,week,t1,,0,,\n"),
        with("stop_times.txt",
             "trip_id,arrival_time,departure_time,stop_id,stop_sequence,stop_headsign\n"
             "t1,8:00:00,8:00:00,a,1,North\nt1,8:05:00,8:05:00,b,2,East\n"
             "t1,8:10:00,8:10:00,c,3,\n")},
       "42 a 8:00 > North b 8:05 > East c 8:10"},
      {"no headsign: the last stop",
       {trips("r1,week,t1,,0,,\n")},
       "42 a 8:00 > Harbour b 8:05 c 8:10"},
      {"route_both_short_and_long_name_missing: its id",
       {with("routes.txt", "route_id,route_type\nr1,3\n")},
       "r1 a 8:00 > Pier b 8:05 c 8:10"},
      {"a long name alone",
       {with("routes.txt", "route_id,route_long_name,route_type\nr1,Town line,3\n")},
       "Town line a 8:00 > Pier b 8:05 c 8:10"},
      {"a block of two trips",
       {trips("r1,week,t1,Pier,0,B,\nr1,week,t2,Market,1,B,\n"),
        plus("stop_times.txt", more_times)},
       as_ever + "; 42 c 8:12 > Market a 8:22"},
      {"several routes, and none is chosen",
       {plus("routes.txt", "r2,T,N8,,3\nr3,T,9,,3\n")},
       "feed/routes.txt: several routes; choose one: r1 (42), r2 (N8), r3 (9)"},
      {"block_trips_with_overlapping_stop_times: two vehicles",
       {trips("r1,week,t1,Pier,0,B,\nr1,week,t2,Market,1,B,\n"),
        plus("stop_times.txt", "t2,8:06:00,8:06:00,c,1\nt2,8:16:00,8:16:00,a,2\n")},
       as_ever + " | 42 c 8:06 > Market a 8:16"},
      {"trips without a block: the vehicle that stands there",
       {plus("trips.txt", "r1,week,t2,Market,1,,\n"), plus("stop_times.txt", more_times)},
       as_ever + "; 42 c 8:12 > Market a 8:22"},
      {"trips without a block that begin too soon: two vehicles",
       {plus("trips.txt", "r1,week,t2,Market,1,,\n"),
        plus("stop_times.txt", "t2,8:11:00,8:11:00,c,1\nt2,8:22:00,8:22:00,a,2\n")},
       as_ever + " | 42 c 8:11 > Market a 8:22"},
      {"duplicate_key: a trip twice",
       {plus("trips.txt", "r1,week,t1,Pier,0,,\n")},
       "feed/trips.txt line 3: trip_id: 't1' is there twice"},
      {"number_out_of_range: a direction of 2",
       {trips("r1,week,t1,Pier,2,,\n")},
       "feed/trips.txt line 2: direction_id: '2' is no whole number from 0 to 1"},
      {"foreign_key_violation: a service that has no days",
       {trips("r1,never,t1,Pier,0,,\n")},
       no_trip},
      {"foreign_key_violation: trips of a route that is not there",
       {plus("trips.txt", "r9,week,t9,,0,,\n")},
       as_ever},
      {"an exception takes the day away",
       {with("calendar_dates.txt", "service_id,date,exception_type\nweek,20261123,2\n")},
       no_trip},
      {"an exception adds the day to a calendar that has ended",
       {with("calendar.txt", days_head + "week,1,1,1,1,1,0,0,20250101,20250131\n"),
        with("calendar_dates.txt", "service_id,date,exception_type\nweek,20261123,1\n")},
       as_ever},
      {"a calendar that ends before it begins",
       {with("calendar.txt", days_head + "week,1,1,1,1,1,0,0,20261231,20261101\n")},
       no_trip},
      {"invalid_date",
       {with("calendar.txt", days_head + "week,1,1,1,1,1,0,0,20261131,20261231\n")},
       "feed/calendar.txt line 2: start_date: '20261131' is no date as 20261123"},
  };
  return all;
}

void expect_all(const std::vector<Oddity>& oddities) {
  for (const Oddity& oddity : oddities) EXPECT_EQ(driven(oddity), oddity.right) << oddity.what;
}

TEST(FeedOddities, OfFiles) {
  expect_all(file_oddities());
}
TEST(FeedOddities, OfTimes) {
  expect_all(time_oddities());
}
TEST(FeedOddities, OfStopsAndShapes) {
  expect_all(stop_oddities());
}
TEST(FeedOddities, OfTripsBlocksAndDays) {
  expect_all(line_oddities());
}

/// The vehicle of a block drives other lines in between, and announces them; trips of other blocks,
/// and of the block on days without one of this line, do not belong to it.
TEST(FeedOddities, ABlockGoesOverSeveralLines) {
  const Oddity oddity = {
      "",
      {plus("routes.txt", "r2,T,N8,,3\nr3,T,42,,3\n"),
       trips("r2,week,t2,Depot,1,B,\nr1,week,t1,Pier,0,B,\nr3,week,t3,,1,C,\nr1,never,t4,,0,C,\n"),
       plus("stop_times.txt",
            "t2,8:12:00,8:12:00,c,1\nt2,8:22:00,8:22:00,a,2\n"
            "t3,9:00:00,9:00:00,a,1\nt3,9:09:00,9:09:00,b,2\n"
            "t4,9:00:00,9:00:00,a,1\nt4,9:09:00,9:09:00,b,2\n")},
      ""};
  const auto archive = gtfs::FeedArchive::of_texts(texts_of(oddity));
  const host::Result<gtfs::Feed> feed = gtfs::read_feed(archive, "r1");
  ASSERT_TRUE(feed) << feed.error().line();
  const bus_line::LineOfFeed made = bus_line::line_of_feed(*feed, monday);
  ASSERT_EQ(made.problem, "");
  ASSERT_EQ(made.line.blocks.size(), 1U);
  const std::vector<bus_line::Journey>& journeys = made.line.blocks[0].journeys;
  ASSERT_EQ(journeys.size(), 2U);
  EXPECT_EQ(text_of(made.line, journeys[0]), as_ever);
  EXPECT_EQ(text_of(made.line, journeys[1]), "N8 c 8:12 > Depot a 8:22");
  const bus_line::LineNames other = made.line.names_of(made.line.routes[journeys[1].route]);
  EXPECT_EQ(other.id, "r2");
  EXPECT_EQ(other.number, 1U) << "its name is no number: the first that no other line has";
  EXPECT_EQ(made.line.number, 42U);
}

struct NameOddity {
  const char* what;
  std::string name;
  std::string right;
};

TEST(FeedOddities, OfNames) {
  const std::string long_name(180, 'n');
  const std::string line = "feed/stops.txt line 2: stop_name: ";
  const std::string save = ", which is no UTF-8 there; save the file as UTF-8";
  const std::vector<NameOddity> all = {
      {"none: the id", "", "a"},
      {"a blank: the id", " ", "a"},
      {"a comma and quotation marks", "\"Market, \"\"old\"\"\"", "Market, \"old\""},
      {"new_line_in_value", "\"Old\nmarket\"", "Old market"},
      {"ends of lines of Windows, and a blank", "\"Old \r\n market\"", "Old market"},
      {"a line end at the end", "\"Market\n\"", "Market"},
      {"a tab", "Old\tmarket", "Old market"},
      {"the line separator of Unicode", "Old\xE2\x80\xA8market", "Old market"},
      {"blanks in a row", "Old   market", "Old market"},
      {"umlauts", "Z\xC3\xBCrich", "Z\xC3\xBCrich"},
      {"Arabic", "\xD8\xB3\xD9\x88\xD9\x82", "\xD8\xB3\xD9\x88\xD9\x82"},
      {"a bus", "\xF0\x9F\x9A\x8C", "\xF0\x9F\x9A\x8C"},
      {"180 characters", long_name, long_name},
      {"a command to the terminal", "\x1B[2J", "\\x1B[2J"},
      {"from right to left", "\xE2\x80\xAEx", "\\xE2\\x80\\xAEx"},
      {"HTML stays what it is", "A &amp; B", "A &amp; B"},
      {"invalid_character: ISO 8859-1", "Caf\xE9", line + "'Caf\\xE9' has the byte E9h" + save},
      {"UTF-8 that is cut", "Z\xC3", line + "'Z\\xC3' has the byte C3h" + save},
      {"not the shortest UTF-8", "\xC0\xAF", line + "'\\xC0\\xAF' has the byte C0h" + save},
      {"half a pair of UTF-16", "\xED\xA0\x80", line + "'\\xED\\xA0\\x80' has the byte EDh" + save},
  };
  for (const NameOddity& each : all) {
    const Oddity oddity = {each.what, {stop("a," + each.name + ",50.1,8.5\n")}, ""};
    bus_line::BusLine made;
    const std::string text = driven(oddity, &made);
    EXPECT_EQ(made.stops.empty() ? text : made.stops.front().name, each.right) << each.what;
  }
}

TEST(FeedOddities, ARouteOf255StopsIsTheLongest) {
  bus_line::BusLine line;
  driven({"", long_trip(255), ""}, &line);
  ASSERT_EQ(line.blocks.size(), 1U);
  EXPECT_EQ(line.routes[0].stops.size(), 255U);
}

/// A feed that is not refused is driven to its end.
TEST(FeedOddities, CanBeDriven) {
  std::size_t count = 0;
  for (const auto* all : {&file_oddities(), &time_oddities(), &stop_oddities(), &line_oddities()}) {
    for (const Oddity& oddity : *all) {
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
  }
  EXPECT_GT(count, 30U);
}

}  // namespace
}  // namespace canvoy::tools::feed_oddities_test
