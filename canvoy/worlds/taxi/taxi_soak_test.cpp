// Some seeds of `make soak-taxi`, without an error and with one that must be detected.
#include "canvoy/worlds/taxi/taxi_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::taxi::taxi_soak_test {
namespace {

/// Faults within half an hour, a shift of an hour.
Duration shift() {
  return tries_all() ? taxi_soak_time : Duration(2h);
}

class TaxiSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TaxiSoak, AllHoldsInSpiteOfFaults) {
  TaxiNetwork network(soak_taxi(GetParam(), shift()));
  network.run_until(Time(shift()));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(TaxiSoak, AWrongConstantIsSeen) {
  TaxiOptions options = soak_taxi(GetParam(), shift());
  enlarge_wheels(options);
  TaxiNetwork network(options);
  network.run_until(Time(tries_all() ? shift() : Duration(1h)));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::distance && !invariant.held;
  }));
}

/// The roof sign lost its power while its boot-up could not be heard: the meter sends its state
/// again.
TEST(TaxiSoakFound, ASignWhoseLossNobodyHeardIsToldAgain) {
  TaxiNetwork network(soak_taxi(176));
  network.run_until(Time(100min));  // the last fault is over
  EXPECT_TRUE(network.all_hold());
}

INSTANTIATE_TEST_SUITE_P(Seeds, TaxiSoak, testing::Range<std::uint64_t>(1, tries_all() ? 11 : 3));

}  // namespace
}  // namespace canvoy::taxi::taxi_soak_test
