// Some seeds of `make soak-excavator`, without an error and with one that must be detected.
#include "canvoy/worlds/excavator/excavator_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::excavator::excavator_soak_test {
namespace {

/// Faults up to ten minutes before its end.
Duration shift() {
  return tries_all() ? excavator_soak_time : Duration(25min);
}

class ExcavatorSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ExcavatorSoak, AllHoldsInSpiteOfFaults) {
  ExcavatorNetwork network(soak_excavator(GetParam(), shift()));
  network.run_until(Time(shift()));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(ExcavatorSoak, ADarkLampIsSeen) {
  ExcavatorOptions options = soak_excavator(GetParam(), shift());
  darken(options);
  ExcavatorNetwork network(options);
  network.run_until(Time(shift()));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::indicators && !invariant.held;
  }));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ExcavatorSoak,
                         testing::Range<std::uint64_t>(1, tries_all() ? 11 : 2));

}  // namespace
}  // namespace canvoy::excavator::excavator_soak_test
