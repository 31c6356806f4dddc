// Two faults of a bus at once, each kind with each: one begins with the other, while it lasts, or
// as it ends. All holds, and what was lost is back and right.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus::bus_fault_pairs_test {
namespace {

std::string broken(const BusNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

#ifdef NDEBUG
constexpr std::size_t step = 1;
#else  // with sanitizers: some pairs
constexpr std::size_t step = 4;
#endif

class BusFaultPairs : public testing::TestWithParam<std::size_t> {};

TEST_P(BusFaultPairs, WithEachOtherKind) {
  constexpr Duration lasts_for = 90s;
  constexpr Duration meets[] = {0s, 45s, lasts_for};
  for (std::size_t other = GetParam() % step; other < fault_kinds; other += step) {
    const ScheduledFault first = {.kind = static_cast<FaultKind>(GetParam()),
                                  .start = Time(8min + 40s),
                                  .duration = lasts_for};
    // Of two that are of a node, the second one is of the other car.
    const ScheduledFault second = {
        .kind = static_cast<FaultKind>(other),
        .node = has_node(static_cast<FaultKind>(other)) ? second_next_stop_id : NodeId{0},
        .start = first.start + meets[(GetParam() + other) % 3],
        .duration = lasts_for};
    BusNetworkOptions options;
    options.faults.seed = 1 + other;
    options.faults.faults = {first, second};
    BusNetwork network(options);
    network.run_until(Time(22min));
    const std::string pair =
        std::string(fault_name(first.kind)) + " and " + std::string(fault_name(second.kind));
    EXPECT_EQ(broken(network), "") << pair;
    for (const auto& node : network.nodes()) {
      EXPECT_TRUE(node->is_operational()) << pair << ": " << node->place().name;
    }
    const std::string& stop = network.vehicle().truth().stop->name;
    EXPECT_EQ(network.display(next_stop_id).text(), stop) << pair;
    EXPECT_EQ(network.display(second_next_stop_id).text(), stop) << pair;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BusFaultPairs, testing::Range<std::size_t>(0, fault_kinds));

}  // namespace
}  // namespace canvoy::bus::bus_fault_pairs_test
