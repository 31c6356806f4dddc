// Some seeds of `make soak-bus`, in both directions.
#include "canvoy/sim/bus/bus_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::bus::bus_soak_test {
namespace {

class BusSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BusSoak, AllHoldsInSpiteOfFaults) {
  BusNetwork network(soak_bus(GetParam()));
  network.run_until(Time(bus_soak_time));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(BusSoak, AFrozenDestinationIsSeen) {
  BusNetworkOptions options = soak_bus(GetParam());
  freeze(options);
  BusNetwork network(options);
  network.run_until(Time(1h));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::lie && !invariant.held;
  }));
}

#ifdef NDEBUG
constexpr std::uint64_t seeds = 10;
#else  // with sanitizers
constexpr std::uint64_t seeds = 3;
#endif
INSTANTIATE_TEST_SUITE_P(Seeds, BusSoak, testing::Range<std::uint64_t>(1, seeds + 1));

}  // namespace
}  // namespace canvoy::bus::bus_soak_test
