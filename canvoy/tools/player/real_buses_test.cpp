#include "canvoy/tools/player/real_buses.hpp"

#include <gtest/gtest.h>

#include "canvoy/sim/world.hpp"

namespace canvoy::tools::real_buses_test {
namespace {

TEST(RealBuses, ANetworkIsAsFastAsTheClock) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  const Time begin = loop->now();
  const Time first = real.reach(begin + 1ms);
  EXPECT_EQ(real.reach(begin + 2ms) - first, 1ms);
  EXPECT_EQ(real.reach(begin + 5ms) - first, 4ms);
}

TEST(RealBuses, AShortPauseIsCaughtUpWithBySteps) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  Time clock = loop->now() + 1ms;
  const Time first = real.reach(clock);
  clock += 20ms;
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(real.reach(clock) - first, i * 5ms);
  EXPECT_EQ(real.reach(clock) - first, 20ms) << "it is there";
  clock += 400ms;
  EXPECT_EQ(real.reach(clock) - first, 20ms + 100ms) << "a quarter";
  for (int i = 0; i < 40; ++i) real.reach(clock);
  EXPECT_EQ(real.reach(clock) - first, 420ms);
  EXPECT_EQ(real.left_out(), 0ms);
}

TEST(RealBuses, OfALongPauseTheRestIsLeftOut) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  Time clock = loop->now() + 1ms;
  const Time first = real.reach(clock);
  clock += 20s;
  real.reach(clock);
  EXPECT_EQ(real.left_out(), 19'500ms);
  for (int i = 0; i < 40; ++i) real.reach(clock);
  EXPECT_EQ(real.reach(clock) - first, 500ms);
}

}  // namespace
}  // namespace canvoy::tools::real_buses_test
