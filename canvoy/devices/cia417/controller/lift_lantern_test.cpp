// Hall lanterns of a lift: lit when the car slows down to a floor, so that waiting passengers go to
// its door, and consistent with its direction (CiA 417-4, 4.4.1: basic function 41h; EN 81-70,
// 5.4.2.3).
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_lantern_test {
namespace {

constexpr auto idle = LiftPhase::idle;
constexpr auto open = LiftPhase::open;

class LiftLanternTest : public LiftBenchTest {
 protected:
  /// Runs until the car cannot pass the floor any more: the bench stops within half a metre.
  bool come_near(std::uint8_t floor) {
    const std::int32_t position = LiftBench::floors[floor - 1U];
    return bench.run_until([&] {
      return std::abs(bench.car.motion.position_micrometre - position) <= bench_metre / 2;
    });
  }
};

TEST_F(LiftLanternTest, ItIsLitWhereTheCarSlowsDown) {
  bench.press("02 02 01 04 10 01");
  const Time pressed = bench.cable.now;
  ASSERT_TRUE(bench.run_until([&] { return bench.told("400#41 02 01 04 10 01") != 0; }));
  EXPECT_EQ(bench.cable.now - pressed, 8490ms)
      << "9 m at 1 m/s, less half a metre of braking and the 10 mm that count as the floor";
  EXPECT_TRUE(bench.doors.are_closed());
  ASSERT_TRUE(bench.run_to(4, open));
  EXPECT_EQ(bench.told("400#41 02 01 04 10 01"), 1u);
  EXPECT_EQ(bench.told("400#41 02 01 04 10 00"), 0u) << "and goes on to be lit";
  ASSERT_TRUE(bench.run_to(4, idle));
  EXPECT_EQ(bench.told("400#41 02 01 04 10 00"), 1u);
}

TEST_F(LiftLanternTest, WhatItPromisedHoldsForWhoComesLater) {
  bench.press("02 02 01 04 10 01");
  ASSERT_TRUE(come_near(4));
  bench.press("02 01 01 07 10 01");
  ASSERT_TRUE(bench.run_to(4, open));
  EXPECT_EQ(lift.direction(), Direction::down) << "though somebody waits above";
  EXPECT_EQ(bench.told("400#41 01 01 04 10 01"), 0u);
  EXPECT_EQ(bench.told("400#02 02 01 04 10 00"), 1u) << "he who saw it is served";
  EXPECT_TRUE(bench.run_to(7, open)) << "and the other one then";
}

TEST_F(LiftLanternTest, ItGoesOutWithTheCallThatItWasFor) {
  bench.press("02 02 01 04 10 01");
  ASSERT_TRUE(come_near(4));
  ASSERT_EQ(bench.told("400#41 02 01 04 10 01"), 1u);
  bench.turn(SpecialFunction::hall_call_disable);
  bench.step();
  EXPECT_EQ(bench.told("400#41 02 01 04 10 00"), 1u);
}

TEST_F(LiftLanternTest, NoneIsLitWhereNobodyIsLetInOrOut) {
  bench.press("05 04 01 00 11 01");
  ASSERT_TRUE(bench.run_to(4, open)) << "who gets out: nobody is told where the car goes on to";
  ASSERT_TRUE(bench.run_to(4, idle));
  bench.turn(SpecialFunction::vip_service);
  bench.press("05 07 01 00 11 01");
  bench.press("05 09 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open)) << "the car is somebody's own";
  for (const char* lantern : {"400#41 01 01 04 10 01", "400#41 02 01 04 10 01",
                              "400#41 01 01 07 10 01", "400#41 02 01 07 10 01"}) {
    EXPECT_EQ(bench.told(lantern), 0u) << lantern;
  }
}

TEST_F(LiftLanternTest, WithAFaultOnTheWayItGoesOut) {
  bench.press("02 02 01 04 10 01");
  ASSERT_TRUE(come_near(4));
  ASSERT_EQ(bench.told("400#41 02 01 04 10 01"), 1u);
  bench.car.motion.available = false;
  bench.step();
  EXPECT_EQ(bench.told("400#41 02 01 04 10 00"), 1u);
}

}  // namespace
}  // namespace canvoy::cia417::lift_lantern_test
