// Some seeds of `make soak-taxi`, in both directions.
#include "canvoy/sim/taxi/taxi_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::taxi::taxi_soak_test {
namespace {

class TaxiSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TaxiSoak, AllHoldsInSpiteOfFaults) {
  TaxiNetwork network(soak_taxi(GetParam()));
  network.run_until(Time(taxi_soak_time));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(TaxiSoak, AWrongConstantIsSeen) {
  TaxiOptions options = soak_taxi(GetParam());
  enlarge_wheels(options);
  TaxiNetwork network(options);
  network.run_until(Time(taxi_soak_time));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::distance && !invariant.held;
  }));
}

/// The roof sign lost its power while nobody could hear that it boots: the meter tells it again.
TEST(TaxiSoakFound, ASignWhoseLossNobodyHeardIsToldAgain) {
  TaxiNetwork network(soak_taxi(176));
  network.run_until(Time(taxi_soak_time));
  EXPECT_TRUE(network.all_hold());
}

#ifdef NDEBUG
constexpr std::uint64_t seeds = 10;
#else  // with sanitizers
constexpr std::uint64_t seeds = 3;
#endif
INSTANTIATE_TEST_SUITE_P(Seeds, TaxiSoak, testing::Range<std::uint64_t>(1, seeds + 1));

}  // namespace
}  // namespace canvoy::taxi::taxi_soak_test
