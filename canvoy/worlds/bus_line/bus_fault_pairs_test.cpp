// Two faults of a bus at once, each kind with each: one begins with the other, while it lasts, or
// as it ends. All invariants hold, and what was lost is back and right.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line::bus_fault_pairs_test {
namespace {

class BusFaultPairs : public testing::TestWithParam<std::size_t> {};

TEST_P(BusFaultPairs, WithEachOtherKind) {
  for (const std::size_t other : kinds_beside(GetParam(), fault_kinds)) {
    BusNetworkOptions options;
    options.faults.seed = 1 + other;
    std::vector<ScheduledFault>& faults = options.faults.faults;
    faults = pair_of_faults<ScheduledFault>(GetParam(), other, Time(8min + 40s), 90s);
    // Of two faults of nodes, the second one is in the other car.
    if (has_node(faults.back().kind)) faults.back().node = next_stop_of(2);
    const std::string pair = pair_name(faults);
    BusNetwork network(options);
    network.run_until(Time(17min));
    EXPECT_EQ(broken_names(network), "") << pair;
    for (const auto& node : network.nodes()) {
      EXPECT_TRUE(node->is_operational()) << pair << ": " << node->place().name;
    }
    const std::string& stop = network.vehicle().truth().stop->name;
    EXPECT_EQ(network.display(next_stop_id).text(), stop) << pair;
    EXPECT_EQ(network.display(next_stop_of(2)).text(), stop) << pair;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BusFaultPairs, testing::Range<std::size_t>(0, fault_kinds));

std::string played_with_wrong_clock(ScheduledFault other, Sabotage sabotage = {}) {
  BusNetworkOptions options;
  options.sabotage = sabotage;
  options.faults.faults = {{.kind = FaultKind::wrong_clock, .start = Time(8min), .duration = 10min},
                           other};
  BusNetwork network(options);
  network.run_until(Time(22min));
  return broken_names(network);
}

/// No device has the time then; as soon as one has it, all have it.
TEST(BusFaultPairsFound, AWrongClockIsGoneByWhereNoSatellitesAreHeard) {
  const ScheduledFault blind = {
      .kind = FaultKind::no_satellites, .start = Time(10min), .duration = 5min};
  EXPECT_EQ(played_with_wrong_clock(blind), "");
  const ScheduledFault lost = {
      .kind = FaultKind::lost_node, .start = Time(10min), .duration = 5min, .node = positioning_id};
  EXPECT_EQ(played_with_wrong_clock(lost), "");
  const ScheduledFault brief = {
      .kind = FaultKind::no_satellites, .start = Time(10min), .duration = 1min};
  EXPECT_EQ(played_with_wrong_clock(brief, {.slow_clocks = true}), "clock ")
      << "it is judged again";
}

}  // namespace
}  // namespace canvoy::bus_line::bus_fault_pairs_test
