#include "canvoy/tools/run/real_buses.hpp"

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

TEST(RealBuses, AShortPauseIsCaughtUpWithAtTwiceTheSpeed) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  Time clock = loop->now() + 1ms;
  const Time first = real.reach(clock);
  clock += 105ms;
  EXPECT_EQ(real.reach(clock) - first, 5ms);
  for (int i = 1; i <= 100; ++i) {
    clock += 1ms;
    EXPECT_EQ(real.reach(clock) - first, 5ms + i * 2ms);
  }
  EXPECT_EQ(real.reach(clock + 1ms) - first, 206ms) << "it is there";
  EXPECT_EQ(real.left_out(), 0ms);
}

TEST(RealBuses, OfALongPauseTheRestIsLeftOut) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  Time clock = loop->now() + 1ms;
  const Time first = real.reach(clock);
  clock += 20s;
  EXPECT_EQ(real.reach(clock) - first, 5ms);
  EXPECT_EQ(real.left_out(), 9995ms);
  for (int i = 0; i < 20'000; ++i) real.reach(clock += 1ms);
  EXPECT_EQ(real.reach(clock) - first, 5ms + 10s + 20s);
}

}  // namespace
}  // namespace canvoy::tools::real_buses_test
