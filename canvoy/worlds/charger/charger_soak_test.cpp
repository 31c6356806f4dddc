// A short soak of the charging world; `make soak-charger` has a long one.
#include "canvoy/worlds/charger/charger_soak.hpp"

#include <gtest/gtest.h>

namespace canvoy::charger::charging_soak_test {
namespace {

constexpr Duration short_time = 6min;
constexpr std::uint64_t seeds = 20;

TEST(ChargerSoak, WithRandomFaultsEveryInvariantHolds) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    ChargerNetwork sut(soak_charging(seed, short_time));
    sut.run_until(Time(short_time));
    for (const Invariant& invariant : sut.invariants()) {
      EXPECT_TRUE(invariant.held) << "seed " << seed << ", kind "
                                  << static_cast<int>(invariant.kind) << ", fault "
                                  << invariant.fault << ": " << invariant.worst << " of "
                                  << invariant.allowed;
    }
    EXPECT_EQ(sut.world().livelocks(), 0U) << seed;
  }
}

TEST(ChargerSoak, AWeldedContactorIsSeenWhateverElseIsWrong) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    ChargerNetwork sut(soak_charging(seed, short_time));
    weld_contactor(sut, short_time);
    sut.run_until(Time(short_time));
    for (const Invariant& invariant : sut.invariants()) {
      if (invariant.kind != InvariantKind::current_outside_handshake) continue;
      EXPECT_FALSE(invariant.held) << seed;
    }
  }
}

TEST(ChargerSoak, ASeedDecidesTheFaults) {
  const std::vector<ScheduledFault> faults = soak_charging(17).faults.faults;
  EXPECT_EQ(faults, soak_charging(17).faults.faults);
  EXPECT_NE(faults, soak_charging(18).faults.faults);
  EXPECT_EQ(faults.back().kind, FaultKind::not_ready);
}

}  // namespace
}  // namespace canvoy::charger::charging_soak_test
