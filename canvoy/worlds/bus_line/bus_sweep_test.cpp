// Where the faults of a sweep begin, and a part of it; `make soak-bus-places` is the whole one.
#include "canvoy/worlds/bus_line/bus_sweep.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace canvoy::bus_line::bus_sweep_test {
namespace {

/// Each kind, and each of 21 devices with each kind of one, in three places.
TEST(BusSweep, HasEachKindInEachPlace) {
  std::map<std::string, std::set<FaultKind>> kinds;
  std::set<NodeId> lost;
  for (const SweptFault& swept : swept_faults(1)) {
    kinds[std::string(swept.place)].insert(swept.fault.kind);
    if (swept.fault.kind == FaultKind::lost_node) lost.insert(swept.fault.node);
  }
  ASSERT_EQ(kinds.size(), 3U);
  for (const auto& [place, all] : kinds) EXPECT_EQ(all.size(), fault_kinds) << place;
  EXPECT_EQ(lost.size(), 22U) << "21 devices, and the usual one";
  EXPECT_EQ(swept_faults(1).size(), 3U * (11 + 3 * 21));
}

/// The truth about the vehicle at the begin of each fault: it stands at the first or last stop of a
/// route, drives, or stands at another stop.
TEST(BusSweep, BeginsWhereItSays) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::map<Time, std::string_view> begins;
    for (const SweptFault& swept : swept_faults(seed)) begins[swept.fault.start] = swept.place;
    BusNetworkOptions options;
    options.faults.seed = seed;
    options.length = bus_sweep_time;
    BusNetwork network(options);
    for (const auto& [at, place] : begins) {
      network.run_until(at);
      const BusTruth truth = network.vehicle().truth();
      const bool is_end = truth.place == 0 || truth.place + 1 == truth.route->stops.size();
      const std::string_view is = !truth.is_at_stop ? "between" : (is_end ? "terminal" : "stop");
      EXPECT_EQ(is, place) << "seed " << seed << " at " << (at - Time{}).count();
    }
  }
}

/// One fault of each kind, at another place each.
TEST(BusSweep, NoVerdictIsWrong) {
  const std::vector<SweptFault> all = swept_faults(1);
  std::size_t place = 0;
  std::set<FaultKind> done;
  for (const SweptFault& swept : all) {
    if (swept.fault.node != 0 || done.contains(swept.fault.kind) || place++ % 4 != 0) continue;
    done.insert(swept.fault.kind);
    for (const std::string& wrong : wrong_verdicts(1, swept)) ADD_FAILURE() << wrong;
  }
  EXPECT_GT(done.size(), 5U);
}

}  // namespace
}  // namespace canvoy::bus_line::bus_sweep_test
