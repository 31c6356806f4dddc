// Compares destination control with collective control in an up-peak, with real nodes. The
// literature (Barney and Al-Sharif, Elevator Traffic Handbook; CIBSE Guide D; Siikonen) expects:
// more people are carried, since cars stop less often, and people who have to wait in a crowd reach
// their destination sooner.
#include <gtest/gtest.h>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::lift::destination_control_test {
namespace {

LiftSummary up_peak(bool destination_control, double percent, std::uint64_t seed) {
  StandardLifts options{
      .lifts = 4, .floors = 20, .destination_control = destination_control, .seed = seed};
  options.traffic = {
      .pattern = TrafficPattern::up_peak, .percent_in_5_minutes = percent, .seed = seed};
  LiftNetwork network(standard_lift_network(options));
  network.run_until(Time(tries_all() ? Duration(30min) : Duration(15min)));
  // Where more people come than can be carried, some give up, which the run reports.
  for (const Invariant& one : network.invariants()) {
    const bool is_of_the_crowd = one.kind == InvariantKind::nobody_gives_up;
    EXPECT_TRUE(one.held || (is_of_the_crowd && network.summary().is_saturated))
        << "seed " << seed << ", " << static_cast<int>(one.kind) << ": " << one.worst;
  }
  return network.summary();
}

class DestinationControlTest : public testing::TestWithParam<std::uint64_t> {};

/// 12 % of the population in five minutes: collective control carries 7 %.
TEST_P(DestinationControlTest, CarriesMorePeopleInAHeavyUpPeakAndBringsThemThereSooner) {
  const LiftSummary collective = up_peak(false, 12, GetParam());
  const LiftSummary destination = up_peak(true, 12, GetParam());
  EXPECT_GE(static_cast<double>(destination.served), 1.2 * static_cast<double>(collective.served));
  EXPECT_GT(destination.most_in_5_minutes, collective.most_in_5_minutes);
  EXPECT_LT(destination.waiting.mean, collective.waiting.mean);
  EXPECT_LT(destination.to_destination.mean, collective.to_destination.mean);
  EXPECT_LT(destination.to_destination.percentile_90, collective.to_destination.percentile_90);
}
INSTANTIATE_TEST_SUITE_P(Seeds, DestinationControlTest,
                         testing::Range<std::uint64_t>(1, tries_all() ? 4 : 2));

}  // namespace
}  // namespace canvoy::lift::destination_control_test
