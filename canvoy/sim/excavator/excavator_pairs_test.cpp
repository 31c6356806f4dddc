// Pairs of faults in an excavator: one begins while another lasts, which ends before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "canvoy/sim/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_pairs_test {
namespace {

class ExcavatorPair : public testing::TestWithParam<std::size_t> {};

ScheduledFault fault_in_pair(std::size_t kind, NodeId node, Time start) {
  ScheduledFault fault{.kind = static_cast<FaultKind>(kind), .start = start, .duration = 20s};
  if (has_node(fault.kind)) fault.node = node;
  return fault;
}

#ifdef NDEBUG
constexpr std::size_t step = 1;
#else  // with sanitizers: some pairs
constexpr std::size_t step = 4;
#endif

TEST_P(ExcavatorPair, AllHoldsAndItDigsWhenBothAreOver) {
  constexpr NodeId nodes[] = {host_id, seat_id, valves_id};
  const std::size_t first = GetParam();
  for (std::size_t second = first % step; second < fault_kinds; second += step) {
    const ScheduledFault one = fault_in_pair(first, nodes[second % 3], Time(1min));
    const ScheduledFault other = fault_in_pair(second, nodes[(first + second) % 3], Time(70s));
    SCOPED_TRACE(std::string(fault_name(one.kind)) + " and " + std::string(fault_name(other.kind)));
    ExcavatorOptions options = with_faults({one, other});
    options.faults.seed = 1 + first * fault_kinds + second;
    ExcavatorNetwork network(options);
    network.run_until(Time(90s));
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
