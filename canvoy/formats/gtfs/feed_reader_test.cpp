#include "canvoy/formats/gtfs/feed_reader.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <map>
#include <utility>

namespace canvoy::gtfs::feed_reader_test {
namespace {

using namespace std::chrono_literals;
using Texts = std::map<std::string, std::string, std::less<>>;

/// Two lines of a small town.
Texts town() {
  return {
      {"agency.txt",
       "agency_id,agency_name,agency_url,agency_timezone,agency_lang\n"
       "T,Town,https://t.example,Europe/Berlin,de\nO,Others,https://o.example,Europe/Paris,fr\n"},
      {"stops.txt",
       "stop_id,stop_name,stop_lat,stop_lon,zone_id\n"
       "a,\"Market, old\",50.1,8.5,A\nb,School,50.11,8.51,A\nc,Harbour,50.12,8.52,B\n"
       "d,Far away,51,9,C\n"},
      {"routes.txt",
       "route_id,agency_id,route_short_name,route_long_name,route_type\n"
       "r1,T,42,Town line,3\nr2,O,7,,3\nr3,T,7,,0\n"},
      {"trips.txt",
       "route_id,service_id,trip_id,trip_headsign,direction_id,block_id,shape_id\n"
       "r1,week,t1,Harbour,0,B1,s1\nr1,week,t2,Market,1,B1,\nr2,week,t3,,,,\n"},
      {"stop_times.txt",
       "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n"
       "t1,23:58:00,23:58:00,a,5\nt1,24:10:00,24:10:00,c,20\nt1,,,b,10\n"
       "t2,24:20:00,24:20:00,c,1\nt2,24:30:00,24:30:00,a,2\nt3,9:00:00,9:00:00,d,1\n"},
      {"calendar.txt",
       "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n"
       "week,1,1,1,1,1,0,0,20261101,20261231\n"},
  };
}

host::Result<Feed> read(Texts texts, std::string_view route = "42") {
  return read_feed(FeedArchive::of_texts(std::move(texts)), route);
}
std::string problem(Texts texts, std::string_view route = "42") {
  const host::Result<Feed> feed = read(std::move(texts), route);
  return feed ? "" : feed.error().line();
}
/// The town with other content of one file.
Texts with(std::string_view file, std::string content) {
  Texts texts = town();
  texts[std::string(file)] = std::move(content);
  return texts;
}
Texts without(std::string_view file) {
  Texts texts = town();
  texts.erase(std::string(file));
  return texts;
}
/// The town with something appended to a file.
Texts plus(const std::string& file, const std::string& more) {
  Texts texts = town();
  texts[file] += more;
  return texts;
}

TEST(FeedReader, KeepsWhatBelongsToTheRoute) {
  const host::Result<Feed> feed = read(town());
  ASSERT_TRUE(feed) << feed.error().line();
  EXPECT_EQ(feed->route.id, "r1");
  EXPECT_EQ(feed->route.name(), "42");
  EXPECT_EQ(feed->agency.name, "Town");
  EXPECT_EQ(feed->agency.timezone, "Europe/Berlin");
  ASSERT_EQ(feed->stops.size(), 3U);
  EXPECT_EQ(feed->stops[0].name, "Market, old");
  EXPECT_EQ(feed->stops[0].zone, "A");
  EXPECT_DOUBLE_EQ(feed->stops[0].latitude, 50.1);
  EXPECT_DOUBLE_EQ(feed->stops[0].longitude, 8.5);
  ASSERT_EQ(feed->trips.size(), 2U);
  EXPECT_EQ(feed->trips[0].headsign, "Harbour");
  EXPECT_EQ(feed->trips[0].direction, 0);
  EXPECT_EQ(feed->trips[0].block, "B1");
  EXPECT_EQ(feed->trips[1].shape, none);
}

TEST(FeedReader, CallsStandInTheOrderOfTheirSequence) {
  const host::Result<Feed> feed = read(town());
  ASSERT_TRUE(feed);
  const std::vector<Call>& calls = feed->trips[0].calls;
  ASSERT_EQ(calls.size(), 3U);
  EXPECT_EQ(feed->stops[calls[0].stop].id, "a");
  EXPECT_EQ(feed->stops[calls[1].stop].id, "b");
  EXPECT_EQ(feed->stops[calls[2].stop].id, "c");
  EXPECT_EQ(calls[2].sequence, 20U);
}

TEST(FeedReader, TimesGoOnAfterMidnight) {
  const host::Result<Feed> feed = read(town());
  ASSERT_TRUE(feed);
  const std::vector<Call>& calls = feed->trips[0].calls;
  EXPECT_EQ(calls[0].departure, TimeOfDay(23h + 58min));
  EXPECT_EQ(calls[1].arrival, std::nullopt);
  EXPECT_FALSE(calls[1].is_timing_point);
  EXPECT_EQ(calls[2].arrival, TimeOfDay(24h + 10min));
}

TEST(FeedReader, ARouteIsFoundByItsIdOrByAShortNameThatIsItsOwn) {
  EXPECT_EQ(problem(town(), "r1"), "");
  EXPECT_EQ(problem(town(), "9"),
            "feed/routes.txt: no route '9'; there are r1 (42), r2 (7), r3 (7)");
  EXPECT_EQ(problem(town(), "7"),
            "feed/routes.txt: several routes are called '7'; choose one by its id: r2 (7), r3 (7)");
  EXPECT_EQ(problem(town(), ""),
            "feed/routes.txt: several routes; choose one: r1 (42), r2 (7), r3 (7)");
  EXPECT_EQ(problem(with("routes.txt", "route_id,route_short_name\nr1,1\n"), ""), "");
}

TEST(FeedReader, FilesThatMustBeThereAreMissed) {
  for (const std::string_view file :
       {"agency.txt", "stops.txt", "routes.txt", "trips.txt", "stop_times.txt"}) {
    EXPECT_EQ(problem(without(file)),
              "feed/" + std::string(file) + ": missing; a GTFS feed has it");
  }
  EXPECT_EQ(problem(without("calendar.txt")),
            "feed/calendar.txt: missing, and calendar_dates.txt as well; a GTFS feed has one of "
            "them");
}

TEST(FeedReader, ServicesRunOnTheirWeekdaysAndOnNoOthers) {
  using std::chrono::day;
  using std::chrono::November;
  using std::chrono::year;
  Texts texts = town();
  texts["calendar_dates.txt"] =
      "service_id,date,exception_type\nweek,20261123,2\nweek,20261128,1\nother,20261129,1\n";
  const host::Result<Feed> feed = read(texts);
  ASSERT_TRUE(feed);
  const auto runs = [&](unsigned d) {
    return feed->runs_on(feed->trips[0], year(2026) / November / day(d));
  };
  EXPECT_FALSE(runs(23));  // a Monday that is removed
  EXPECT_TRUE(runs(24));
  EXPECT_TRUE(runs(27));
  EXPECT_TRUE(runs(28));  // a Saturday that is added
  EXPECT_FALSE(runs(29));
  EXPECT_FALSE(feed->runs_on(feed->trips[0], year(2026) / 10 / 30));  // before its start
  EXPECT_FALSE(feed->runs_on(feed->trips[0], year(2027) / 1 / 1));
}

TEST(FeedReader, DaysMayStandInCalendarDatesAlone) {
  Texts texts = without("calendar.txt");
  texts["calendar_dates.txt"] = "service_id,date,exception_type\nweek,20261123,1\n";
  const host::Result<Feed> feed = read(texts);
  ASSERT_TRUE(feed);
  EXPECT_TRUE(feed->runs_on(feed->trips[0], std::chrono::year(2026) / 11 / 23));
  EXPECT_FALSE(feed->runs_on(feed->trips[0], std::chrono::year(2026) / 11 / 24));
}

TEST(FeedReader, ShapesAndFrequenciesAreReadWhereTheyAre) {
  Texts texts = town();
  texts["shapes.txt"] =
      "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence,shape_dist_traveled\n"
      "s1,50.12,8.52,9,2.5\ns1,50.1,8.5,1,0\nother,1,1,1,\n";
  texts["frequencies.txt"] = "trip_id,start_time,end_time,headway_secs\nt2,06:00:00,25:00:00,600\n";
  texts["feed_info.txt"] = "feed_publisher_name,feed_lang,feed_version\nTown,de,\"3, third\"\n";
  const host::Result<Feed> feed = read(texts);
  ASSERT_TRUE(feed) << feed.error().line();
  ASSERT_EQ(feed->shapes.size(), 1U);
  EXPECT_EQ(feed->trips[0].shape, 0U);
  ASSERT_EQ(feed->shapes[0].points.size(), 2U);
  EXPECT_EQ(feed->shapes[0].points[0].distance, 0.0);
  EXPECT_DOUBLE_EQ(feed->shapes[0].points[1].latitude, 50.12);
  ASSERT_EQ(feed->trips[1].frequencies.size(), 1U);
  EXPECT_EQ(feed->trips[1].frequencies[0].end, TimeOfDay(25h));
  EXPECT_EQ(feed->trips[1].frequencies[0].headway, 600s);
  EXPECT_EQ(feed->info.version, "3, third");
}

TEST(FeedReader, WhatIsWrongIsToldWithFileLineAndColumn) {
  const std::string times = "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n";
  const std::vector<std::pair<Texts, std::string>> cases = {
      {plus("stops.txt", "b,Twice,1,1,\n"), "feed/stops.txt line 6: stop_id: it is there twice"},
      {with("stops.txt", "stop_id,stop_name,stop_lat,stop_lon\na,A,91,8\n"),
       "feed/stops.txt line 2: stop_lat: '91' is no number from -90 to 90"},
      {with("stops.txt", "stop_id,stop_name,stop_lat,stop_lon\na,A,nan,8\n"),
       "feed/stops.txt line 2: stop_lat: 'nan' is no number from -90 to 90"},
      {with("stops.txt", "stop_id,stop_name,stop_lon\na,A,8\n"),
       "feed/stops.txt line 2: stop_lat: the column is missing"},
      {with("stops.txt", "stop_id,stop_name,stop_lat,stop_lon\na,Market, old,50,8\n"),
       "feed/stops.txt line 2: 5 fields, and 4 columns; is a text with commas without quotation "
       "marks?"},
      {with("stops.txt", "stop_id,stop_lat,stop_lon\na,1,1\nb,1,1\n"),
       "feed/stop_times.txt line 3: stop_id: stops.txt has no 'c'"},
      {with("stops.txt", ""), "feed/stops.txt line 1: empty; the names of its columns are missing"},
      {with("stops.txt", "stop_id,stop_lat,stop_lat\n"),
       "feed/stops.txt line 1: stop_lat: the column is there twice"},
      {plus("trips.txt", "r1,week,t1,,,,\n"),
       "feed/trips.txt line 5: trip_id: 't1' is there twice"},
      {plus("trips.txt", "r1,week,t9,,2,,\n"),
       "feed/trips.txt line 5: direction_id: '2' is no whole number from 0 to 1"},
      {plus("trips.txt", "r1,,t9,,,,\n"), "feed/trips.txt line 5: service_id: empty"},
      {plus("stop_times.txt", "t1,1:60:00,,a,30\n"),
       "feed/stop_times.txt line 8: arrival_time: '1:60:00' is no time as 08:05:00"},
      {plus("stop_times.txt", "t1,25:00:00,25:00:00,a,20\n"),
       "feed/stop_times.txt line 8: stop_sequence: the trip has it twice"},
      {plus("stop_times.txt", "t1,,,a,30\n"),
       "feed/stop_times.txt line 8: arrival_time: the ends of a trip must have one"},
      {with("stop_times.txt", times + "t1,09:00:00,09:00:00,a,1\nt1,08:59:59,09:01:00,b,2\n"),
       "feed/stop_times.txt line 3: arrival_time: before the stop before it"},
      {with("stop_times.txt", times + "t1,09:00:00,08:59:59,a,1\n"),
       "feed/stop_times.txt line 2: departure_time: before the arrival"},
      {with("calendar.txt", town()["calendar.txt"] + "week,1,1,1,1,1,1,1,20260101,20270101\n"),
       "feed/calendar.txt line 3: service_id: it is there twice"},
      {with("calendar_dates.txt", "service_id,date,exception_type\nweek,20260230,1\n"),
       "feed/calendar_dates.txt line 2: date: '20260230' is no date as 20261123"},
      {with("calendar_dates.txt", "service_id,date,exception_type\nweek,20260228,0\n"),
       "feed/calendar_dates.txt line 2: exception_type: neither 1 (added) nor 2 (removed)"},
      {with("frequencies.txt", "trip_id,start_time,end_time,headway_secs\nt1,1:00:00,2:00:00,0\n"),
       "feed/frequencies.txt line 2: headway_secs: 0 or empty"},
      {with("shapes.txt", "shape_id,shape_pt_lat,shape_pt_lon,shape_pt_sequence\ns1,1,1,-1\n"),
       "feed/shapes.txt line 2: shape_pt_sequence: '-1' is no whole number from 0 to 4294967295"},
  };
  for (const auto& [texts, expected] : cases) EXPECT_EQ(problem(texts), expected);
}

TEST(FeedReader, ATextThatIsShownCommandsNoTerminal) {
  const host::Result<Feed> feed = read(with("stops.txt",
                                            "stop_id,stop_name,stop_lat,stop_lon\na,\x1B[2J,1,1\n"
                                            "b,\xE2\x80\xAE,1,1\nc,Z\xC3\xBC"
                                            "rich,1,1\n"));
  ASSERT_TRUE(feed) << feed.error().line();
  // In the order of their first occurrence in stop_times.txt: a, c, b.
  EXPECT_EQ(feed->stops[0].name, "[2J");
  EXPECT_EQ(feed->stops[1].name,
            "Z\xC3\xBC"
            "rich");
  EXPECT_EQ(feed->stops[2].name, "") << "a mark of direction alone is no text";
}

TEST(FeedReader, OfManyTripsOnlyThoseOfTheRouteAreKept) {
  Texts texts = town();
  std::string& times = texts["stop_times.txt"];
  for (int i = 0; i < 200'000; ++i) {
    times += "x" + std::to_string(i / 20) + ",08:00:00,08:00:00,s" + std::to_string(i % 20) + "," +
             std::to_string(i % 20) + "\n";
  }
  times += "t2,24:40:00,24:40:00,b,3\n";
  const host::Result<Feed> feed = read(texts);
  ASSERT_TRUE(feed);
  EXPECT_EQ(feed->stops.size(), 3U);
  EXPECT_EQ(feed->trips[1].calls.size(), 3U);
}

}  // namespace
}  // namespace canvoy::gtfs::feed_reader_test
