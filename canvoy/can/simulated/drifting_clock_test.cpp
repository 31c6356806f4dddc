#include "canvoy/can/simulated/drifting_clock.hpp"

#include <gtest/gtest.h>

namespace canvoy::drifting_clock_test {
namespace {

TEST(DriftingClock, WithoutDriftShowsTheTimeOfTheWorld) {
  constexpr DriftingClock sut;
  EXPECT_EQ(sut.node_time(Time(1234567us)), Time(1234567us));
  EXPECT_EQ(sut.world_time(Time(1234567us)), Time(1234567us));
}

TEST(DriftingClock, GainsOrLosesItsPartsPerMillion) {
  EXPECT_EQ(DriftingClock(50).node_time(Time(1s)), Time(1s + 50us));
  EXPECT_EQ(DriftingClock(-50).node_time(Time(1s)), Time(1s - 50us));
  EXPECT_EQ(DriftingClock(100).node_time(Time(24h)), Time(24h + 8640ms));
}

TEST(DriftingClock, RoundsDownAndLosesNothingOverAHundredYears) {
  EXPECT_EQ(DriftingClock(1).node_time(Time(999'999us)), Time(999'999us));
  EXPECT_EQ(DriftingClock(1).node_time(Time(1'000'000us)), Time(1'000'001us));
  const Duration century = 876'600h;
  EXPECT_EQ(DriftingClock(3).node_time(Time(century)), Time(century + century / 1'000'000 * 3));
}

TEST(DriftingClock, AnswersTheFirstInstantAtWhichTheNodesClockShowsATime) {
  for (const std::int32_t ppm : {-200'000, -101, -1, 1, 37, 100'000}) {
    const DriftingClock sut(ppm);
    for (std::int64_t us = 1; us < 5'000'000'000; us = us * 3 + 1) {
      const Time deadline{Duration(us)};
      const Time wake = sut.world_time(deadline);
      EXPECT_GE(sut.node_time(wake), deadline) << ppm;
      EXPECT_LT(sut.node_time(wake - 1us), deadline) << ppm;
    }
  }
}

TEST(DriftingClock, KnowsThatNeverIsNever) {
  EXPECT_EQ(DriftingClock(100).node_time(never), never);
  EXPECT_EQ(DriftingClock(100).world_time(never), never);
}

}  // namespace
}  // namespace canvoy::drifting_clock_test
