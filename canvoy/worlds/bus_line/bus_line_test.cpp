#include "canvoy/worlds/bus_line/bus_line.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::bus_line_test {
namespace {

TEST(BuiltInLine, RunsEach40MinutesFromFiveTo24h20) {
  const BusLine line = built_in_line();
  const std::vector<Journey>& journeys = line.blocks.at(0).journeys;
  ASSERT_EQ(line.blocks.size(), 1u);
  ASSERT_EQ(journeys.size(), 58u) << "29 there and 29 back";
  for (std::size_t i = 0; i < journeys.size(); ++i) {
    EXPECT_EQ(journeys[i].number, i + 1);
    EXPECT_EQ(journeys[i].trip, "built-in-" + std::to_string(i + 1));
    EXPECT_EQ(journeys[i].route, i % 2);
    EXPECT_EQ(journeys[i].passings.front().departure, 5h + static_cast<int>(i) * 20min);
    EXPECT_EQ(journeys[i].passings.back().arrival, 5h + static_cast<int>(i) * 20min + 16min);
  }
  EXPECT_LE(journeys.back().passings.back().arrival, 24h + 20min);
}

TEST(BuiltInLine, AJourneyHasTheTimesOfItsStopsThereAndBack) {
  const BusLine line = built_in_line();
  const int minutes[2][8] = {{0, 2, 4, 6, 9, 11, 13, 16}, {0, 3, 5, 7, 10, 12, 14, 16}};
  for (std::size_t way = 0; way < 2; ++way) {
    const std::vector<Passing>& passings = line.blocks[0].journeys[way].passings;
    ASSERT_EQ(passings.size(), 8u);
    for (std::size_t i = 0; i < passings.size(); ++i) {
      const Duration at = passings[0].departure + minutes[way][i] * 1min;
      EXPECT_EQ(passings[i].arrival, at);
      EXPECT_EQ(passings[i].departure, at);
      EXPECT_EQ(passings[i].sequence, i + 1);
      EXPECT_EQ(passings[i].is_timing_point, i == 0 || i == 3 || i == 6);
    }
  }
}

TEST(BuiltInLine, ItsRoutesHaveTheStopsInBothOrders) {
  const BusLine line = built_in_line();
  ASSERT_EQ(line.stops.size(), 8u);
  EXPECT_EQ(line.stops[0].number, 1u);
  EXPECT_EQ(line.stops[7].number, 8u);
  EXPECT_EQ(line.stop(0, 0).name, "Central Station");
  EXPECT_EQ(line.stop(1, 0).name, "Harbour");
  EXPECT_EQ(line.routes.at(0).destination, "Harbour");
  EXPECT_EQ(line.routes.at(1).destination, "Central Station");
  EXPECT_EQ(line.routes[0].number, 1u);
  EXPECT_EQ(line.routes[1].number, 2u);
  EXPECT_FALSE(line.routes[0].is_backward);
  EXPECT_TRUE(line.routes[1].is_backward);
  EXPECT_NEAR(line.routes[0].stops.back().metres, line.routes[1].stops.back().metres, 1);
}

// Segments have two links; the border of a zone ends one.
TEST(BuiltInLine, SegmentsEndAfterTwoLinksAndAtTheBorderOfAZone) {
  const BusLine line = built_in_line();
  const unsigned segments[8] = {1, 1, 2, 2, 1, 1, 2, 2};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(line.routes[0].stops[i].route_segment, segments[i]) << i;
    EXPECT_EQ(line.routes[0].stops[i].fare_zone, i < 4 ? 1 : 2) << i;
  }
}

}  // namespace
}  // namespace canvoy::bus_line::bus_line_test
