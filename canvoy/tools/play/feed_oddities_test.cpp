// Oddities of stops, shapes, trips and names of timetables, each as a small feed: the resulting
// drive of the bus, or the reason of the refusal. Expected results follow from the GTFS Schedule
// reference (gtfs.org) and the CSV of RFC 4180; the kinds are those of the notices of the canonical
// validator, with their names.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/tools/play/feed_oddities_test.hpp"

namespace canvoy::tools::feed_oddities_test {
namespace {

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
      {"point_near_pole",
       {stop("a,Market,-89.99,8.5\n")},
       "feed/stops.txt line 2: stop_lat: at a pole: the place of the stop is missing"},
      {"location_with_unexpected_stop_time, wrong_parent_location_type, and a type of 9",
       {with("stops.txt",
             "stop_id,stop_name,stop_lat,stop_lon,location_type,parent_station\n"
             "a,A,50.1,8.5,1,b\nb,B,50.11,8.51,9,zz\nc,C,50.12,8.52,,\n")},
       as_ever},
      {"location_without_parent_station, unused_station: nobody calls there",
       {with("stops.txt",
             "stop_id,stop_name,stop_lat,stop_lon,location_type,parent_station\n"
             "a,A,50.1,8.5,,\nb,B,50.11,8.51,,\nc,C,50.12,8.52,,\ne,Exit,50.1,8.5,2,\n"
             "s,Station,50.1,8.5,1,\n")},
       as_ever},
      {"decreasing_shape_distance, equal_shape_distance_diff_coordinates",
       {trips("r1,week,t1,Pier,0,,s\n"),
        with("shapes.txt",
             "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence,shape_dist_traveled\n"
             "s,50.1,8.5,1,9\ns,50.11,8.51,2,3\ns,50.12,8.52,3,3\n")},
       as_ever},
      {"unused_shape",
       {with("shapes.txt", "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence\nz,9,9,1\n")},
       as_ever},
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
      {"duplicate_key: a route twice",
       {plus("routes.txt", "r1,T,43,Other line,3\n")},
       "feed/routes.txt line 3: route_id: it is there twice"},
      {"duplicate_route_name, and none is chosen",
       {plus("routes.txt", "r2,T,42,Town line,3\n")},
       "feed/routes.txt: several routes; choose one: r1 (42), r2 (42)"},
      {"unexpected_enum_value: a route_type of 99; foreign_key_violation of the agency",
       {with("routes.txt", "route_id,agency_id,route_short_name,route_type\nr1,X,42,99\n")},
       as_ever},
      {"inconsistent_agency_timezone: that of the agency of the route",
       {plus("agency.txt", "U,Other,https://u.example,Asia/Tokyo\n")},
       as_ever},
      {"trip_headsign_matches_intermediate_stop",
       {trips("r1,week,t1,School,0,,\n")},
       "42 a 8:00 > School b 8:05 c 8:10"},
      {"service_has_no_active_day_of_the_week",
       {with("calendar.txt", days_head + "week,0,0,0,0,0,0,0,20261101,20261231\n")},
       no_trip},
      {"expired_calendar, future_calendar",
       {with("calendar.txt", days_head + "week,1,1,1,1,1,1,1,20200101,20201231\n")},
       no_trip},
      {"duplicate_key: a service twice",
       {plus("calendar.txt", "week,1,1,1,1,1,1,1,20261101,20261231\n")},
       "feed/calendar.txt line 3: service_id: it is there twice"},
      {"unexpected_enum_value: a Monday of 2",
       {with("calendar.txt", days_head + "week,2,1,1,1,1,0,0,20261101,20261231\n")},
       "feed/calendar.txt line 2: monday: '2' is no whole number from 0 to 1"},
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
      {"a command to the terminal", "\x1B[2J", "[2J"},
      {"from right to left", "\xE2\x80\xAEx", "x"},
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
  EXPECT_GT(expect_driven(stop_oddities()) + expect_driven(line_oddities()), 25U);
}

}  // namespace
}  // namespace canvoy::tools::feed_oddities_test
