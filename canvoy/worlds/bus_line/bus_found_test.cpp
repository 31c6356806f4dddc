// Days of a bus on which its computer could once not find its position again: faults where a
// journey ends and the next one begins, and between stops. All invariants hold.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line::bus_found_test {
namespace {

struct FoundCase {
  std::uint64_t seed;
  Duration length;
  std::vector<const char*> faults;
};
std::ostream& operator<<(std::ostream& out, const FoundCase& it) {
  out << "seed " << it.seed;
  for (const char* const fault : it.faults) out << ", " << fault;
  return out;
}

/// Journeys end after about 20 min, and begin after 5, 25 and 45 min.
std::vector<FoundCase> found_cases() {
  std::vector<FoundCase> cases = {
      // The last position before the end is lost, and none comes at the first stop.
      {17, 30min, {"no-satellites@1214.5s+300s"}},
      // Tickets must not have the zone of the journey before.
      {22, 28min, {"no-satellites@1200s+300s"}},
      // A position that has waited for ten minutes must be ignored.
      {6, 28min, {"babbling-node@673.5s+600s"}},
      // With the gateway dead, people of the second car press without effect.
      {8, 31min, {"lost-node:node=31@1530s+600s"}},
      // The computer does not receive that doors open.
      {401, 11min, {"corrupted-frames@488.05s+90s", "cable-cut@488.25s+30s"}},
      // While no journey is received, the bus leaves a stop: it is not the next one any more.
      {4, 10min, {"lost-node:node=2@433720ms+1min"}},
      {5, 17min, {"cable-cut:node=1@912493ms+10s"}}};
  if (!tries_all()) return cases;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const char* const fault :
         {"no-satellites@1205s+300s", "no-satellites@1230s+600s", "babbling-node@1236s+1s",
          "babbling-node@1236s+600s", "lost-node:node=16@1230s+300s", "restart:node=1@1510s",
          "lost-node:node=31@1530s+600s"}) {
      cases.push_back({seed, 45min, {fault}});
    }
  }
  return cases;
}

class BusFound : public testing::TestWithParam<FoundCase> {};

TEST_P(BusFound, AllHolds) {
  BusNetworkOptions options;
  options.faults.seed = GetParam().seed;
  for (const char* const fault : GetParam().faults) {
    const ParsedFault<FaultKind> parsed = parse_fault<FaultKind>(fault);
    ASSERT_TRUE(parsed.fault) << parsed.error;
    options.faults.faults.push_back(*parsed.fault);
  }
  BusNetwork network(options);
  network.run_until(Time(GetParam().length));
  EXPECT_EQ(broken_names(network), "");
}

INSTANTIATE_TEST_SUITE_P(Each, BusFound, testing::ValuesIn(found_cases()));

/// A driver who has braked for a timing point must not creep past it.
TEST(BusFoundWithoutAFault, NobodyIsToldAnotherStopThanTheNextOne) {
  BusNetworkOptions options;
  options.faults.seed = 453;
  BusNetwork network(options);
  network.run_until(Time(33min));
  EXPECT_EQ(broken_names(network), "");
}

/// A line of one direction: to the next start, in another fare zone, it drives without passengers.
class BusFoundElsewhere : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BusFoundElsewhere, NoZoneIsToldBeforeTheBusStandsAtItsStop) {
  BusNetworkOptions options;
  options.faults.seed = GetParam();
  std::vector<Journey>& journeys = options.line.blocks[0].journeys;
  journeys.resize(1);
  journeys.push_back(journeys[0]);
  journeys[1].number = 2;
  for (Passing& passing : journeys[1].passings) {
    passing.arrival += 50min;
    passing.departure += 50min;
  }
  const BusRoute& route = options.line.routes[journeys[0].route];
  ASSERT_NE(route.stops.front().fare_zone, route.stops.back().fare_zone);
  BusNetwork network(options);
  network.run_until(Time(70min));
  EXPECT_EQ(broken_names(network), "");
}

INSTANTIATE_TEST_SUITE_P(Some, BusFoundElsewhere,
                         testing::Range<std::uint64_t>(1, tries_all() ? 9 : 3));

}  // namespace
}  // namespace canvoy::bus_line::bus_found_test
