// Some seeds of `make soak-excavator`, in both directions.
#include "canvoy/sim/excavator/excavator_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::excavator::excavator_soak_test {
namespace {

class ExcavatorSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ExcavatorSoak, AllHoldsInSpiteOfFaults) {
  ExcavatorNetwork network(soak_excavator(GetParam()));
  network.run_until(Time(excavator_soak_time));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(ExcavatorSoak, ADarkLampIsSeen) {
  ExcavatorOptions options = soak_excavator(GetParam());
  darken(options);
  ExcavatorNetwork network(options);
  network.run_until(Time(excavator_soak_time));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::indicators && !invariant.held;
  }));
}

#ifdef NDEBUG
constexpr std::uint64_t seeds = 10;
#else  // with sanitizers
constexpr std::uint64_t seeds = 3;
#endif
INSTANTIATE_TEST_SUITE_P(Seeds, ExcavatorSoak, testing::Range<std::uint64_t>(1, seeds + 1));

}  // namespace
}  // namespace canvoy::excavator::excavator_soak_test
