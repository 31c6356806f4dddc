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

TEST(RealBuses, WhatTheMachineDidNotGetToIsLeftOut) {
  World world;
  const auto loop = *host::EventLoop::create();
  RealBuses real(world, {}, *loop);
  const Time begin = loop->now();
  const Time first = real.reach(begin + 1ms);
  const Duration before = real.left_out();
  EXPECT_EQ(real.reach(begin + 2s + 1ms) - first, 5ms);
  EXPECT_EQ(real.left_out() - before, 1995ms);
  EXPECT_EQ(real.reach(begin + 2s + 2ms) - first, 6ms);
}

}  // namespace
}  // namespace canvoy::tools::real_buses_test
