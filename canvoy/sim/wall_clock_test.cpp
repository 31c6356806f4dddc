#include "canvoy/sim/wall_clock.hpp"

#include <gtest/gtest.h>

namespace canvoy::wall_clock_test {
namespace {

using namespace std::chrono;

constexpr CivilTime evening = sys_days{2026y / November / 21} + 18h;

TEST(WallClock, ShowsWhatHasPassedInTheWorldSinceItsBegin) {
  World world;
  const WallClock sut(world, evening);
  EXPECT_EQ(sut.now(), (TimeOfDay{.milliseconds = 64'800'000, .days = 15'665}));
  world.run_until(Time(1'999us));
  EXPECT_EQ(sut.now()->milliseconds, 64'800'001U) << "it is never ahead";
  world.run_until(Time(6h));
  EXPECT_EQ(sut.now(), (TimeOfDay{.milliseconds = 0, .days = 15'666})) << "midnight";
}

TEST(WallClock, HasNoTimeThatAMessageCannotHold) {
  World world;
  EXPECT_EQ(WallClock(world, sys_days{1983y / December / 31}).now(), std::nullopt);
}

}  // namespace
}  // namespace canvoy::wall_clock_test
