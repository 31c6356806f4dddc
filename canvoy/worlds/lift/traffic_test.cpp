#include "canvoy/worlds/lift/traffic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace canvoy::lift::traffic_test {
namespace {

std::vector<Arrival> all_of(Traffic traffic) {
  std::vector<Arrival> all;
  while (const std::optional<Arrival> arrival = traffic.next()) all.push_back(*arrival);
  return all;
}

const Building ten_floors = uniform_building({.floors = 10, .population_per_floor = 100});

TEST(BuildingTest, AFloorIsWhereItsHeightIs) {
  EXPECT_EQ(ten_floors.height_m(3), 7.0);
  EXPECT_EQ(ten_floors.floor_near(7.0099, 0.010), 3);
  EXPECT_EQ(ten_floors.floor_near(7.0101, 0.010), no_floor);
  EXPECT_EQ(ten_floors.floor_near(-0.005, 0.010), 1);
  EXPECT_EQ(ten_floors.population(), 900);
}

TEST(TrafficTest, PoissonArrivalsHaveTheRateAndTheSpreadThatWereAskedFor) {
  // 900 people, 10 % in 5 minutes: 90 in each, so 10,800 in ten hours.
  const std::vector<Arrival> all =
      all_of(Traffic(ten_floors, {.percent_in_5_minutes = 10, .until = Time(600min), .seed = 3}));
  EXPECT_NEAR(static_cast<double>(all.size()), 10'800, 4 * std::sqrt(10'800));
  std::vector<double> in_window(120);
  for (const Arrival& arrival : all) {
    in_window.at(static_cast<std::size_t>(arrival.at.time_since_epoch() / 5min)) += 1;
  }
  double squares = 0;
  for (const double count : in_window) squares += (count - 90) * (count - 90);
  // Mean and variance of a Poisson process are the same.
  EXPECT_NEAR(squares / 120, 90, 45);
}

TEST(TrafficTest, InUpPeakAllComeInAtTheMainFloor) {
  const auto all =
      all_of(Traffic(ten_floors, {.pattern = TrafficPattern::up_peak, .until = Time(60min)}));
  ASSERT_FALSE(all.empty());
  for (const Arrival& arrival : all) {
    EXPECT_EQ(arrival.from, 1);
    EXPECT_NE(arrival.to, 1);
  }
}

TEST(TrafficTest, InDownPeakAllLeaveAtTheMainFloor) {
  const auto all =
      all_of(Traffic(ten_floors, {.pattern = TrafficPattern::down_peak, .until = Time(60min)}));
  ASSERT_FALSE(all.empty());
  for (const Arrival& arrival : all) {
    EXPECT_EQ(arrival.to, 1);
    EXPECT_NE(arrival.from, 1);
  }
}

TEST(TrafficTest, InterfloorTrafficLeavesTheMainFloorOut) {
  const auto all =
      all_of(Traffic(ten_floors, {.pattern = TrafficPattern::interfloor, .until = Time(60min)}));
  ASSERT_FALSE(all.empty());
  for (const Arrival& arrival : all) {
    EXPECT_NE(arrival.from, 1);
    EXPECT_NE(arrival.to, 1);
    EXPECT_NE(arrival.from, arrival.to);
  }
}

TEST(TrafficTest, LunchHasAsManyWhoLeaveAsWhoComeAndSomeBetweenFloors) {
  const auto all =
      all_of(Traffic(ten_floors, {.pattern = TrafficPattern::lunch, .until = Time(600min)}));
  double in = 0;
  double out = 0;
  for (const Arrival& arrival : all) {
    in += arrival.from == 1 ? 1 : 0;
    out += arrival.to == 1 ? 1 : 0;
  }
  const auto count = static_cast<double>(all.size());
  EXPECT_NEAR(in / count, 0.45, 0.03);
  EXPECT_NEAR(out / count, 0.45, 0.03);
}

TEST(TrafficTest, FloorsAreDrawnByTheirPopulation) {
  Building building = uniform_building({.floors = 4, .population_per_floor = 0});
  building.floors[1].population = 300;
  building.floors[3].population = 100;
  const auto all = all_of(Traffic(
      building,
      {.pattern = TrafficPattern::up_peak, .percent_in_5_minutes = 20, .until = Time(300min)}));
  double second = 0;
  for (const Arrival& arrival : all) {
    EXPECT_NE(arrival.to, 3);
    second += arrival.to == 2 ? 1 : 0;
  }
  EXPECT_NEAR(second / static_cast<double>(all.size()), 0.75, 0.03);
}

TEST(TrafficTest, PeopleWeighWhatTheyWeigh) {
  const auto all = all_of(Traffic(ten_floors, {.until = Time(600min)}));
  double sum = 0;
  double squares = 0;
  for (const Arrival& arrival : all) {
    EXPECT_GE(arrival.mass_kg, 35);
    sum += arrival.mass_kg;
    squares += (arrival.mass_kg - 75) * (arrival.mass_kg - 75);
  }
  const auto count = static_cast<double>(all.size());
  EXPECT_NEAR(sum / count, 75, 1);
  EXPECT_NEAR(std::sqrt(squares / count), 12, 1);
}

TEST(TrafficTest, TheSameSeedBringsTheSamePeopleAndAnotherOneOthers) {
  const TrafficOptions options{.until = Time(60min), .seed = 7};
  TrafficOptions other = options;
  other.seed = 8;
  EXPECT_EQ(all_of(Traffic(ten_floors, options)), all_of(Traffic(ten_floors, options)));
  EXPECT_NE(all_of(Traffic(ten_floors, options)), all_of(Traffic(ten_floors, other)));
}

TEST(TrafficTest, AListIsPlayedInTheOrderOfItsTimes) {
  const Arrival late{.at = Time(9s), .from = 2, .to = 1, .mass_kg = 80};
  const Arrival early{.at = Time(3s), .from = 1, .to = 4, .mass_kg = 60};
  EXPECT_EQ(all_of(Traffic({late, early})), (std::vector<Arrival>{early, late}));
}

TEST(TrafficTest, WhoHardlyEverComesComesBeyondAllTime) {
  // One person in 10^18 years, and times beyond the range of Time.
  for (const double percent : {1e-20, 1e-30, 1e-300}) {
    for (const Time until : {Time(60min), never}) {
      Traffic sut(ten_floors, {.percent_in_5_minutes = percent, .until = until});
      EXPECT_FALSE(sut.next()) << percent;
    }
  }
}

TEST(TrafficTest, NobodyComesToABuildingWithOneFloorOrWithoutPeople) {
  const Building low = uniform_building({.floors = 1});
  const Building empty = uniform_building({.floors = 5, .population_per_floor = 0});
  EXPECT_TRUE(all_of(Traffic(low, {.until = Time(60min)})).empty());
  EXPECT_TRUE(all_of(Traffic(empty, {.until = Time(60min)})).empty());
}

}  // namespace
}  // namespace canvoy::lift::traffic_test
