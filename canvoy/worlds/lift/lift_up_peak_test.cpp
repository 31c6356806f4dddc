// Compares a pure up-peak with real nodes with the classical calculation: interval and handling
// capacity agree within 10 %, for one to eight lifts, in low and in tall buildings.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/round_trip_time.hpp"
#include "canvoy/worlds/lift/statistics.hpp"

namespace canvoy::lift::lift_up_peak_test {
namespace {

struct Group {
  LiftNumber lifts = 1;
  FloorNumber floors = 10;
};
void PrintTo(const Group& group, std::ostream* out) {
  *out << int{group.lifts} << " lifts of " << int{group.floors} << " floors";
}

/// Cars take 0.8 of 13 persons.
constexpr double persons = 10;
/// Time for which a door stays open after the last person has passed (LiftTimes::dwell_again).
constexpr double dwell_s = 2;
/// In relation to the capacity of the cars: enough people come that cars are always full, as the
/// calculation assumes.
constexpr double demand = 1.5;
/// Round trips until people form a queue.
constexpr double warm_up = 2;
/// Round trips of all cars after that: cars may follow each other closely, so that a part of a
/// round means little.
constexpr unsigned rounds = 4;
/// A single lift makes more of them.
constexpr unsigned departures_least = 20;

LiftNetworkDescription up_peak(const Group& group, double percent) {
  StandardLifts options{.lifts = group.lifts, .floors = group.floors};
  options.traffic = {.pattern = TrafficPattern::up_peak, .percent_in_5_minutes = percent};
  LiftNetworkDescription description = standard_lift_network(options);
  description.people.holds_door = 0;
  return description;
}

RoundTrip calculated(const Group& group) {
  RoundTripOptions options = round_trip_options(up_peak(group, 1).building, persons);
  options.dwell_s = dwell_s;
  return round_trip_time(options);
}

Time at_second(double seconds) {
  return Time(Duration(std::llround(seconds * 1e6)));
}

/// Departures of whole rounds of all cars.
unsigned departures_of(const Group& group) {
  return std::max(rounds, (departures_least + group.lifts - 1) / group.lifts) * group.lifts;
}

/// Statistics of this many departures from the main floor, and the one before them.
DepartureStatistics watch(LiftNetwork& network, Time from, unsigned departures) {
  DepartureStatistics seen;
  std::size_t next = 0;
  while (seen.count() <= departures && network.now() < from + 4h) {
    network.run_until(network.now() + 30s);
    for (; next < network.events().size() && seen.count() <= departures; ++next) {
      const LiftEvent& event = network.events()[next];
      const auto* const started = std::get_if<CarStarted>(&event.what);
      if (started == nullptr || started->floor != 1 || started->persons == 0) continue;
      if (event.at >= from) seen.departed(event.at, started->persons);
    }
  }
  return seen;
}

class LiftUpPeakTest : public testing::TestWithParam<Group> {};

TEST_P(LiftUpPeakTest, IntervalAndHandlingCapacityAreThoseOfTheCalculation) {
  const RoundTrip expected = calculated(GetParam());
  const double population = 50.0 * (GetParam().floors - 1);
  LiftNetwork network(
      up_peak(GetParam(), demand * expected.persons_in_5_minutes / population * 100));
  const DepartureStatistics seen =
      watch(network, at_second(warm_up * expected.round_trip_s), departures_of(GetParam()));
  // More people come than can be carried: all other invariants hold.
  for (const Invariant& one : network.invariants()) {
    EXPECT_TRUE(one.held || one.kind == InvariantKind::nobody_gives_up)
        << static_cast<int>(one.kind);
    EXPECT_TRUE(one.held || network.summary().is_saturated);
  }
  EXPECT_NEAR(seen.persons_mean(), persons, 0.5);
  EXPECT_NEAR(seen.interval_s(), expected.interval_s, expected.interval_s * 0.1);
  EXPECT_NEAR(seen.persons_in_5_minutes(), expected.persons_in_5_minutes,
              expected.persons_in_5_minutes * 0.1);
}

std::vector<Group> groups() {
  if (!tries_all()) return {{2, 10}, {4, 10}};
  std::vector<Group> all;
  for (const LiftNumber lifts : std::to_array<LiftNumber>({1, 2, 4, 6, 8})) {
    for (const FloorNumber floors : std::to_array<FloorNumber>({10, 20, 40})) {
      all.push_back({lifts, floors});
    }
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Groups, LiftUpPeakTest, testing::ValuesIn(groups()));

}  // namespace
}  // namespace canvoy::lift::lift_up_peak_test
