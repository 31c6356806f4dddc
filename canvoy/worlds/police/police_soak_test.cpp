// Some seeds of `make soak-police`, without an error and with one that must be detected.
#include "canvoy/worlds/police/police_soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/can/testing/tries_all.hpp"

namespace canvoy::police::police_soak_test {
namespace {

/// Faults within half an hour.
Duration patrol() {
  return tries_all() ? police_soak_time : Duration(2h);
}

class PoliceSoak : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PoliceSoak, AllHoldsInSpiteOfFaults) {
  PoliceNetwork network(soak_police(GetParam(), patrol()));
  network.run_until(Time(patrol()));
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << ": " << invariant.worst;
  }
}

TEST_P(PoliceSoak, ADarkRoofIsSeen) {
  PoliceOptions options = soak_police(GetParam(), patrol());
  darken(options);
  PoliceNetwork network(options);
  network.run_until(Time(tries_all() ? Duration(2h) : Duration(1h)));
  EXPECT_TRUE(std::ranges::any_of(network.invariants(), [](const Invariant& invariant) {
    return invariant.kind == InvariantKind::blue_light && !invariant.held;
  }));
}

/// The control of blue light boots so quickly that the terminal does not lose it, and sends no keys
/// for its lock: the control reads them, or the first key after it is lost.
TEST(PoliceSoakFound, TheFirstKeyAfterABootOfTheControlHasItsEffect) {
  PoliceNetwork network(soak_police(58));
  network.run_until(Time(40min));
  EXPECT_TRUE(network.all_hold());
}

INSTANTIATE_TEST_SUITE_P(Seeds, PoliceSoak, testing::Range<std::uint64_t>(1, tries_all() ? 7 : 2));

}  // namespace
}  // namespace canvoy::police::police_soak_test
