// Pairs of faults in an excavator: one begins with another, while it lasts, or as it ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_pairs_test {
namespace {

class ExcavatorPair : public testing::TestWithParam<std::size_t> {};

TEST_P(ExcavatorPair, AllHoldsAndItDigsWhenBothAreOver) {
  constexpr NodeId nodes[] = {host_id, seat_id, valves_id};
  const std::size_t first = GetParam();
  for (const std::size_t second : kinds_beside(first, fault_kinds)) {
    auto faults = pair_of_faults<ScheduledFault>(first, second, Time(1min), 20s);
    SCOPED_TRACE(pair_name(faults));
    if (has_node(faults.front().kind)) faults.front().node = nodes[second % 3];
    if (has_node(faults.back().kind)) faults.back().node = nodes[(first + second) % 3];
    ExcavatorOptions options = with_faults(std::move(faults));
    options.faults.seed = 1 + first * fault_kinds + second;
    ExcavatorNetwork network(options);
    network.run_until(Time(100s));
    const double heap = network.machine().earth().heaped;
    network.run_until(Time(4min));
    EXPECT_EQ(broken(network), Names());
    EXPECT_GT(network.machine().earth().heaped, heap + 1);
  }
}
INSTANTIATE_TEST_SUITE_P(All, ExcavatorPair, testing::Range(std::size_t{0}, fault_kinds),
                         [](const auto& param) {
                           std::string name(fault_name(static_cast<FaultKind>(param.param)));
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace canvoy::excavator::excavator_pairs_test
