// Some seeds of `make soak-bus`, without an error and with one that must be detected.
#include "canvoy/worlds/bus_line/bus_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::bus_line::bus_soak_test {
namespace {

/// Faults within half an hour.
Duration day() {
  return tries_all() ? bus_soak_time : Duration(1h);
}

class BusSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BusSoak, AllHoldsInSpiteOfFaults) {
  BusNetwork network(soak_bus(GetParam(), day()));
  network.run_until(Time(day()));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(BusSoak, AFrozenDestinationIsSeen) {
  BusNetworkOptions options = soak_bus(GetParam(), day());
  freeze(options);
  BusNetwork network(options);
  network.run_until(Time(1h));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::lie && !invariant.held;
  }));
}

INSTANTIATE_TEST_SUITE_P(Seeds, BusSoak, testing::Range<std::uint64_t>(1, tries_all() ? 11 : 3));

}  // namespace
}  // namespace canvoy::bus_line::bus_soak_test
