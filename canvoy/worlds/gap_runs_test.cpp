// A short sweep of gaps through each world; `make soak-gaps` is the long one.
#include "canvoy/worlds/gap_runs.hpp"

#include <gtest/gtest.h>

#include "canvoy/worlds/charger/charger_soak.hpp"

namespace canvoy::gap_runs_test {
namespace {

#ifdef NDEBUG
constexpr std::uint64_t seeds = 10;
#else  // with sanitizers
constexpr std::uint64_t seeds = 2;
#endif

class Gaps : public testing::TestWithParam<SimulatedWorld> {};

TEST_P(Gaps, LeaveNobodyStandingForLongerThanTheyLastAndAreNoticed) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const GapRun run = GetParam().gap(seed);
    for (const std::string& wrong : run.wrong) {
      ADD_FAILURE() << "seed " << seed << ", " << run.fault << ": " << wrong;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachWorld, Gaps,
                         testing::ValuesIn(simulated_worlds().begin(), simulated_worlds().end()),
                         [](const auto& row) { return std::string(row.param.name); });

/// The campaign's sums are those of its runs.
TEST(Soak, TellsItsTimeAndItsFaults) {
  const SoakRun run = simulated_worlds()[1].soak(1);
  EXPECT_EQ(run.time, charger::charging_soak_time);
  EXPECT_EQ(run.sabotaged_time, charger::charging_soak_time);
  EXPECT_EQ(run.faults, charger::soak_charging(1).faults.faults.size());
}

}  // namespace
}  // namespace canvoy::gap_runs_test
