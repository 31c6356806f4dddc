// A line with a bus each ten minutes: people come at random, and who is late carries more of them.
// Expected numbers follow from the means; docs/bus.md has the measured figures beside published
// ones.
#include "canvoy/worlds/bus_line/line_day.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/bus_line/bus_depot.hpp"

namespace canvoy::bus_line::line_day_test {
namespace {

const unsigned days = tries_all() ? 5 : 3;

/// The built-in line with four vehicles, which follow each other after so many minutes.
BusLine frequent_line(Duration headway = 10min) {
  BusLine line = built_in_line();
  const Block first = line.blocks[0];
  for (std::uint32_t i = 1; i < 4; ++i) {
    Block block = first;
    block.number = i + 1;
    for (Journey& journey : block.journeys) {
      journey.number += i * 100;
      for (Passing& passing : journey.passings) {
        passing.arrival += i * headway;
        passing.departure += i * headway;
      }
    }
    line.blocks.push_back(std::move(block));
  }
  return line;
}

std::vector<BusOptions> vehicles(const BusLine& line, std::uint64_t seed) {
  std::vector<BusOptions> all(line.blocks.size());
  for (BusOptions& each : all) each.seed = seed++;
  return all;
}

TEST(LineDay, KnowsTheVehicleAhead) {
  const BusLine line = frequent_line();
  EXPECT_TRUE(LineDay::is_frequent(line));
  EXPECT_FALSE(LineDay::is_frequent(built_in_line())) << "40 min";
  BusLine seldom = frequent_line(13min);
  seldom.blocks.pop_back();
  EXPECT_FALSE(LineDay::is_frequent(seldom)) << "13, 13 and 14 min";
  const LineDay day(line, vehicles(line, 1));
  EXPECT_FALSE(day.ahead(0, 1, 0)) << "the first one of the day";
  const auto ahead = day.ahead(1, 101, 3);
  ASSERT_TRUE(ahead && ahead->left);
  EXPECT_EQ(ahead->headway, 10min);
  EXPECT_GE(*ahead->left, 5h + 6min) << "Old Bridge is a timing point";
  EXPECT_LT(*ahead->left, 5h + 10min);
  // The first vehicle of the second round follows the last one of the first.
  EXPECT_EQ(day.ahead(0, 3, 0)->headway, 10min);
  EXPECT_FALSE(day.ahead(0, 99, 0));
  EXPECT_FALSE(day.ahead(0, 1, 50));
}

/// The rate of people is one mean in each planned headway, whatever the vehicles do.
TEST(LineDay, AsManyPeopleComeAsByTheTimetable) {
  const BusLine line = frequent_line();
  double at_random = 0;
  double by_timetable = 0;
  for (std::uint64_t seed = 1; seed <= days; ++seed) {
    const auto day = std::make_shared<const LineDay>(line, vehicles(line, 100 * seed));
    for (std::size_t block = 0; block < line.blocks.size(); ++block) {
      for (const bool is_shared : {false, true}) {
        BusOptions options{.seed = 100 * seed + block};
        if (is_shared) {
          options.riders.ahead = [&](std::uint32_t journey, std::size_t stop) {
            return day->ahead(block, journey, stop);
          };
        }
        BusVehicle bus(line, block, options);
        while (!bus.is_over() && bus.deadline() < Time(30h)) bus.advance(bus.deadline());
        (is_shared ? at_random : by_timetable) +=
            static_cast<double>(bus.riders().statistics().came);
      }
    }
  }
  std::printf("at random %.0f, by the timetable %.0f\n", at_random, by_timetable);
  EXPECT_NEAR(at_random / by_timetable, 1, 0.05);
}

/// TriMet, Portland: 43.1 people aboard of trips behind their headway, 37.7 of trips before it
/// (Strathman, Kimpel and Callas, 2003).
TEST(LineDay, WhoIsBehindItsHeadwayCarriesMore) {
  const BusLine line = frequent_line();
  double late = 0;
  double early = 0;
  Headways headways;
  for (std::uint64_t seed = 1; seed <= days; ++seed) {
    auto buses = vehicles(line, 100 * seed);
    // The first vehicle is late all day: it is 4 min behind at each stop.
    auto delays = std::make_shared<Delays>();
    for (std::size_t stop = 0; stop < line.stops.size(); ++stop) {
      delays->add({.stop = stop, .value = 4min});
    }
    buses[0].delays = delays;
    const LineDay day(line, buses);
    late += day.greatest_load(true);
    early += day.greatest_load(false);
    headways.add(day.headways());
  }
  std::printf("late %.1f, early %.1f aboard; headways vary by %.2f, %.3f bunched\n", late / days,
              early / days, headways.variation(), headways.bunched());
  EXPECT_GT(late / early, 1.1);
  EXPECT_GT(headways.count(), 1400U * days);
}

TEST(Headways, AreMeasuredAsInTheManual) {
  Headways headways;
  EXPECT_EQ(headways.variation(), 0);
  headways.add(10min, 10min);
  EXPECT_EQ(headways.variation(), 0);
  EXPECT_EQ(headways.bunched(), 0);
  // Pairs: 0 and 20 min in place of 10 are +-10 min, in relation to 10 min.
  Headways pairs;
  pairs.add(10min, 0min);
  pairs.add(10min, 20min);
  EXPECT_DOUBLE_EQ(pairs.variation(), 1);
  EXPECT_DOUBLE_EQ(pairs.bunched(), 0.5);
  pairs.add(headways);
  EXPECT_EQ(pairs.count(), 3U);
}

/// In a depot, with all devices: who follows a late vehicle finds fewer people, and each vehicle
/// alone is played as in its depot.
TEST(LineDay, VehiclesOfADepotShareTheirPeople) {
  BusNetworkOptions depot;
  depot.line = frequent_line();
  depot.faults.seed = 7;
  depot.length = 45min;
  BusNetworkOptions third = depot_vehicle(depot, 3);
  EXPECT_EQ(day_of(depot, 4), 0U);
  EXPECT_EQ(day_of(depot, 5), 1U);
  const auto day = line_day_of(depot_vehicle(depot, 1), 8h);
  ASSERT_TRUE(day);
  // The same day, found from another vehicle of it.
  EXPECT_EQ(line_day_of(third, 8h)->headways().variation(), day->headways().variation());
  share_people(third, day);
  BusNetwork network(third);
  network.run_until(network.end());
  const VehicleReport report = report_of(network, 3);
  EXPECT_TRUE(report.all_hold());
  EXPECT_GT(report.riders.in, 0U);
  EXPECT_GT(report.statistics.headways.count(), 10U);
  DepotTotals totals;
  totals.add(report);
  EXPECT_EQ(totals.statistics.headways.count(), report.statistics.headways.count());
}

}  // namespace
}  // namespace canvoy::bus_line::line_day_test
