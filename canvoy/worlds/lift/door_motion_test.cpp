// Compares the closed form of a moving door with the laws of motion.
#include "canvoy/worlds/lift/door_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "canvoy/can/random.hpp"

namespace canvoy::lift::door_motion_test {
namespace {

TEST(DoorMotion, SpeedsUpRunsAndSlowsDown) {
  DoorMotion door;
  door.rest(Time(1s), 0);
  door.go(Time(1s), {.target_m = 1.0, .speed_m_s = 0.5, .acceleration_m_s2 = 1.0});
  EXPECT_DOUBLE_EQ(door.position_m(Time(1s)), 0);
  EXPECT_DOUBLE_EQ(door.position_m(Time(1500ms)), 0.125);
  EXPECT_DOUBLE_EQ(door.speed_m_s(Time(1500ms)), 0.5);
  EXPECT_DOUBLE_EQ(door.position_m(Time(2500ms)), 0.625);
  EXPECT_DOUBLE_EQ(door.position_m(Time(3s)), 0.875);
  EXPECT_EQ(door.end(), Time(3500ms)) << "0.5 s, 1.5 s and 0.5 s";
  EXPECT_EQ(door.position_m(door.end()), 1.0);
  EXPECT_EQ(door.speed_m_s(door.end()), 0);
  EXPECT_EQ(door.position_m(Time(1h)), 1.0);
}

TEST(DoorMotion, AShortWayHasNoConstantSpeed) {
  DoorMotion door;
  door.rest(Time{}, 1.0);
  door.go(Time{}, {.target_m = 0.84, .speed_m_s = 0.5, .acceleration_m_s2 = 1.0});
  EXPECT_NEAR(door.speed_m_s(Time(400ms)), -0.4, 1e-9);
  EXPECT_EQ(door.end(), Time(800ms));
}

TEST(DoorMotion, TurnsRoundWithoutAJumpOfItsSpeed) {
  DoorMotion door;
  door.rest(Time{}, 0);
  door.go(Time{}, {.target_m = 1.0, .speed_m_s = 0.5, .acceleration_m_s2 = 1.0});
  door.go(Time(1s), {.target_m = 0, .speed_m_s = 0.5, .acceleration_m_s2 = 1.0});
  EXPECT_NEAR(door.position_m(Time(1s)), 0.375, 1e-9);
  EXPECT_NEAR(door.speed_m_s(Time(1s)), 0.5, 1e-9);
  EXPECT_NEAR(door.position_m(Time(1500ms)), 0.5, 1e-9) << "the turning point";
  EXPECT_NEAR(door.speed_m_s(Time(1500ms)), 0, 1e-9);
  EXPECT_EQ(door.position_m(Time(1h)), 0);
}

TEST(DoorMotion, TellsWhenItComesBy) {
  DoorMotion door;
  door.rest(Time{}, 0);
  door.go(Time{}, {.target_m = 1.0, .speed_m_s = 0.5, .acceleration_m_s2 = 1.0});
  EXPECT_EQ(door.time_at(0.125, Time{}), Time(500ms));
  EXPECT_EQ(door.time_at(0.625, Time{}), Time(1500ms));
  EXPECT_EQ(door.time_at(0.625, Time(1500ms)), never) << "it does not come by again";
  EXPECT_EQ(door.time_at(1.1, Time{}), never);
}

/// Random commands at random times: position and speed never jump, speed and acceleration stay
/// within the requested limits, and the door rests exactly at its target.
TEST(DoorMotion, AnyOrdersAtAnyTimesAreContinuous) {
  Random random(417);
  DoorMotion door;
  door.rest(Time{}, 0.3);
  Time now{};
  for (int i = 0; i < 1000; ++i) {
    const double speed_before = door.speed_m_s(now);
    const double position_before = door.position_m(now);
    const DoorMotion::Way way{
        .target_m = static_cast<double>(random.below(1000)) / 1000,
        .speed_m_s = 0.1 + static_cast<double>(random.below(9)) / 10,
        .acceleration_m_s2 = 0.5 + static_cast<double>(random.below(20)) / 10};
    if (random.below(8) == 0) {
      door.stop(now, way.acceleration_m_s2);
    } else {
      door.go(now, way);
      ASSERT_EQ(door.position_m(door.end()), way.target_m);
    }
    ASSERT_NEAR(door.position_m(now), position_before, 1e-9);
    ASSERT_TRUE(door.speed_m_s(now) == 0 || std::abs(door.speed_m_s(now) - speed_before) < 1e-9);
    const Time end = now + Duration(static_cast<Duration::rep>(random.below(2'000'000)));
    double position = door.position_m(now);
    while (now < end) {
      now += 5ms;
      const double next = door.position_m(now);
      ASSERT_LE(std::abs(next - position), 0.005 * 1.3) << "no faster than the fastest order";
      position = next;
    }
  }
}

}  // namespace
}  // namespace canvoy::lift::door_motion_test
