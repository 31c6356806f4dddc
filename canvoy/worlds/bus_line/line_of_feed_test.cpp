#include "canvoy/worlds/bus_line/line_of_feed.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace canvoy::bus_line::line_of_feed_test {
namespace {

constexpr gtfs::Date monday = std::chrono::year(2026) / 11 / 23;

gtfs::Call call(std::size_t stop, std::chrono::seconds at) {
  return {.stop = stop, .arrival = at, .departure = at, .sequence = 10};
}

/// Three stops on the equator, 0.01 degrees (1112 m) from each other, and a trip there and back.
gtfs::Feed feed() {
  gtfs::Feed made;
  made.route = {.id = "r", .short_name = "42"};
  made.stops = {{.id = "a", .name = "A", .zone = "north", .longitude = 0},
                {.id = "b", .name = "B", .zone = "north", .longitude = 0.01},
                {.id = "c", .name = "C", .zone = "south", .longitude = 0.02}};
  made.services = {{.id = "s", .added = {monday}}};
  gtfs::Trip there{.id = "there", .service = "s", .headsign = "South"};
  there.calls = {call(0, 8h), {.stop = 1, .is_timing_point = false}, call(2, 8h + 10min)};
  gtfs::Trip back{.id = "back", .service = "s", .direction = std::uint8_t{1}};
  back.calls = {call(2, 8h + 12min), call(0, 25h)};
  made.trips = {back, there};
  return made;
}

TEST(LineOfFeed, TripsThatFollowEachOtherAreOneBlock) {
  const LineOfFeed made = line_of_feed(feed(), monday);
  ASSERT_EQ(made.problem, "");
  EXPECT_EQ(made.line.number, 42U);
  ASSERT_EQ(made.line.blocks.size(), 1U);
  const std::vector<Journey>& journeys = made.line.blocks[0].journeys;
  ASSERT_EQ(journeys.size(), 2U);
  EXPECT_EQ(journeys[0].trip, "there");
  EXPECT_EQ(journeys[1].trip, "back");
  EXPECT_EQ(journeys[1].passings.back().arrival, 25h);
  EXPECT_EQ(made.line.routes[journeys[0].route].destination, "South");
  EXPECT_EQ(made.line.routes[journeys[1].route].destination, "A");
  EXPECT_TRUE(made.line.routes[journeys[1].route].is_backward);
}

TEST(LineOfFeed, AStopWithoutATimeIsBetweenThoseThatHaveOne) {
  const LineOfFeed made = line_of_feed(feed(), monday);
  EXPECT_EQ(made.line.blocks[0].journeys[0].passings[1].arrival / 1s * 1s, 8h + 5min);
}

TEST(LineOfFeed, ZonesWithoutNumbersAreCounted) {
  const LineOfFeed made = line_of_feed(feed(), monday);
  const std::vector<RouteStop>& stops =
      made.line.routes[made.line.blocks[0].journeys[0].route].stops;
  EXPECT_EQ(stops[0].fare_zone, 1);
  EXPECT_EQ(stops[0].route_segment, 1);
  EXPECT_EQ(stops[1].route_segment, 2);
  EXPECT_EQ(stops[2].fare_zone, 2);
  EXPECT_EQ(stops[2].route_segment, 1);
}

TEST(LineOfFeed, ADayWithoutTripsHasNoLine) {
  EXPECT_EQ(line_of_feed(feed(), std::chrono::year(2026) / 11 / 24).problem,
            "no trip of the route runs on this day");
}

TEST(LineOfFeed, FrequenciesRepeatATrip) {
  gtfs::Feed often = feed();
  often.trips = {often.trips[1]};
  often.trips[0].frequencies = {{.start = 10h, .end = 11h, .headway = 20min}};
  const LineOfFeed made = line_of_feed(often, monday);
  ASSERT_EQ(made.line.blocks.size(), 3U);
  EXPECT_EQ(made.line.blocks[2].journeys[0].passings[0].departure, 10h + 40min);
  EXPECT_EQ(made.line.blocks[2].journeys[0].passings[2].arrival, 10h + 50min);
}

}  // namespace
}  // namespace canvoy::bus_line::line_of_feed_test
