// Some seeds of `make soak-police`, in both directions.
#include "canvoy/sim/police/police_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::police::police_soak_test {
namespace {

class PoliceSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PoliceSoak, AllHoldsInSpiteOfFaults) {
  PoliceNetwork network(soak_police(GetParam()));
  network.run_until(Time(police_soak_time));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(PoliceSoak, ADarkRoofIsSeen) {
  PoliceOptions options = soak_police(GetParam());
  darken(options);
  PoliceNetwork network(options);
  network.run_until(Time(2h));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::blue_light && !invariant.held;
  }));
}

#ifdef NDEBUG
constexpr std::uint64_t seeds = 6;
#else  // with sanitizers
constexpr std::uint64_t seeds = 3;
#endif
INSTANTIATE_TEST_SUITE_P(Seeds, PoliceSoak, testing::Range<std::uint64_t>(1, seeds + 1));

}  // namespace
}  // namespace canvoy::police::police_soak_test
