// The curves of CiA 417-4, figure 1. Expected numbers are worked out by hand, with round limits.
#include "canvoy/devices/cia417/drive/motion_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace canvoy::cia417::motion_profile_test {
namespace {

using cia402::ProfileType;

constexpr double exact = 1e-9;

/// 2 m/s, 1 m/s2, 1 m/s3: the jerk lasts a second on each bend.
constexpr MotionLimits round_limits = {.velocity = 2,
                                       .acceleration = 1,
                                       .deceleration = 1,
                                       .jerk = {1, 1, 1, 1},
                                       .type = ProfileType::jerk_limited};

void expect_state(const MotionState& state, const MotionState& expected) {
  EXPECT_NEAR(state.position, expected.position, exact);
  EXPECT_NEAR(state.velocity, expected.velocity, exact);
  EXPECT_NEAR(state.acceleration, expected.acceleration, exact);
}

TEST(MotionProfile, HasSevenPiecesWhereTheWayIsLong) {
  // 1 s of jerk, 1 s of acceleration, 1 s of jerk: 2 m/s after 3 s and 3 m; 4 m cruise; the same
  // back.
  const auto trip = MotionProfile::to_position({}, 10, round_limits);
  EXPECT_NEAR(trip.duration(), 8, exact);
  expect_state(trip.at(0), {0, 0, 0});
  expect_state(trip.at(1), {1.0 / 6, 0.5, 1});
  expect_state(trip.at(2), {1.0 / 6 + 0.5 + 0.5, 1.5, 1});
  expect_state(trip.at(3), {3, 2, 0});
  expect_state(trip.at(4), {5, 2, 0});
  expect_state(trip.at(5), {7, 2, 0});
  expect_state(trip.at(6), {10 - 7.0 / 6, 1.5, -1});
  EXPECT_EQ(trip.at(8), (MotionState{10, 0, 0}));
  EXPECT_EQ(trip.at(1000), (MotionState{10, 0, 0}));
  EXPECT_NEAR(trip.peak_velocity(), 2, exact);
}

TEST(MotionProfile, GoesDownAsItGoesUp) {
  const auto up = MotionProfile::to_position({}, 10, round_limits);
  const auto down = MotionProfile::to_position({}, -10, round_limits);
  for (double t = 0; t < 9; t += 0.125) {
    const MotionState mirrored = down.at(t);
    expect_state(up.at(t), {-mirrored.position, -mirrored.velocity, -mirrored.acceleration});
  }
}

TEST(MotionProfile, DoesNotReachTheVelocityOnAShortWay) {
  // Four bends of 0.5 s each: half a jerk of 1 m/s3, 0.25 m/s, 0.25 m.
  const auto trip = MotionProfile::to_position({}, 0.25, round_limits);
  EXPECT_NEAR(trip.duration(), 2, 1e-6);
  EXPECT_NEAR(trip.at(1).velocity, 0.25, 1e-6);
  EXPECT_NEAR(trip.at(0.5).acceleration, 0.5, 1e-6);
  EXPECT_EQ(trip.end().position, 0.25);
}

TEST(MotionProfile, JumpsInItsAccelerationWhereTheJerkIsNotLimited) {
  MotionLimits limits = round_limits;
  limits.jerk = {};
  const auto trip = MotionProfile::to_position({}, 8, limits);
  EXPECT_NEAR(trip.duration(), 2 + 2 + 2, exact);
  expect_state(trip.at(1), {0.5, 1, 1});
  expect_state(trip.at(3), {4, 2, 0});
  expect_state(trip.at(5), {7.5, 1, -1});
}

TEST(MotionProfile, OfLinearRampsKnowsNoJerk) {
  MotionLimits limits = round_limits;
  limits.type = ProfileType::linear;
  expect_state(MotionProfile::to_velocity({}, 2, limits).at(1), {0.5, 1, 1});
}

TEST(MotionProfile, GivesEachBendItsJerk) {
  MotionLimits limits = round_limits;
  limits.jerk = {1, 2, 4, 0.5};
  const auto trip = MotionProfile::to_position({}, 20, limits);
  EXPECT_NEAR((trip.at(0.2).acceleration - trip.at(0.1).acceleration) / 0.1, 1, 1e-6);
  // Up: 1 s, then 1.25 s of acceleration, then 0.5 s.
  EXPECT_NEAR((trip.at(2.5).acceleration - trip.at(2.4).acceleration) / 0.1, -2, 1e-6);
  const double end = trip.duration();
  EXPECT_NEAR((trip.at(end - 0.1).acceleration - trip.at(end - 0.2).acceleration) / 0.1, 0.5, 1e-6);
  // Down: 0.25 s, then 0.875 s of deceleration, then 2 s.
  const double start = end - 2 - 0.875 - 0.25;
  EXPECT_NEAR((trip.at(start + 0.2).acceleration - trip.at(start + 0.1).acceleration) / 0.1, -4,
              1e-6);
}

TEST(MotionProfile, SlowsDownByItsOwnDeceleration) {
  MotionLimits limits = round_limits;
  limits.jerk = {};
  limits.deceleration = 2;
  const auto trip = MotionProfile::to_position({}, 8, limits);
  // 2 s and 2 m up, 1 s and 1 m down, 5 m between.
  EXPECT_NEAR(trip.duration(), 2 + 2.5 + 1, exact);
}

TEST(MotionProfile, PassesItsTargetWithTheEndVelocityAndKeepsIt) {
  const auto trip = MotionProfile::to_position({}, 10, round_limits, 0.5);
  expect_state(trip.at(trip.duration()), {10, 0.5, 0});
  expect_state(trip.at(trip.duration() + 2), {11, 0.5, 0});
}

TEST(MotionProfile, PassesItsTargetSlowerWhereTheWayIsTooShortForTheEndVelocity) {
  const auto trip = MotionProfile::to_position({}, 0.125, round_limits, 2);
  // Two bends of 0.5 s: 0.25 m/s after 0.125 m.
  EXPECT_NEAR(trip.end().velocity, 0.25, 1e-6);
  EXPECT_EQ(trip.end().position, 0.125);
}

TEST(MotionProfile, KeepsAVelocity) {
  const auto trip = MotionProfile::to_velocity({}, -2, round_limits);
  EXPECT_NEAR(trip.duration(), 3, exact);
  expect_state(trip.at(3), {-3, -2, 0});
  expect_state(trip.at(10), {-17, -2, 0});
}

TEST(MotionProfile, StopsFromTheMiddleOfItsAcceleration) {
  const auto trip = MotionProfile::to_position({}, 10, round_limits);
  const MotionState now = trip.at(1.5);  // 1 m/s, 1 m/s2
  const auto stop = MotionProfile::to_velocity(now, 0, round_limits);
  // The acceleration goes first: 1 s, up to 1.5 m/s; then 1 s, 0.5 s, 1 s down.
  EXPECT_NEAR(stop.duration(), 3.5, exact);
  EXPECT_NEAR(stop.peak_velocity(), 1.5, exact);
  EXPECT_EQ(stop.end().velocity, 0);
  EXPECT_NEAR(stop.end().position - now.position,
              MotionProfile::stopping_distance(now, round_limits), exact);
}

TEST(MotionProfile, TurnsRoundThroughAStandstill) {
  const auto turn = MotionProfile::to_velocity({0, 2, 0}, -2, round_limits);
  EXPECT_NEAR(turn.duration(), 6, exact);
  expect_state(turn.at(3), {3, 0, 0});
  expect_state(turn.at(6), {0, -2, 0});
}

TEST(MotionProfile, TellsWhetherATargetCanStillBeReached) {
  const MotionState fast = {0, 2, 0};  // stops within 3 m
  EXPECT_TRUE(MotionProfile::can_reach(fast, 3, round_limits));
  EXPECT_FALSE(MotionProfile::can_reach(fast, 2.99, round_limits));
  EXPECT_FALSE(MotionProfile::can_reach(fast, -1, round_limits));
  EXPECT_TRUE(MotionProfile::can_reach(fast, 0.01, round_limits, 2)) << "without slowing down";
  EXPECT_TRUE(MotionProfile::can_reach({}, -1, round_limits)) << "standing, both ways are open";
}

TEST(MotionProfile, ComesBackToATargetThatItCouldNotReach) {
  const auto trip = MotionProfile::to_position({0, 2, 0}, 1, round_limits);
  EXPECT_EQ(trip.end(), (MotionState{1, 0, 0}));
  expect_state(trip.at(3), {3, 0, 0});
}

TEST(MotionProfile, PlannedAgainOnItsWayIsTheSameProfile) {
  const auto trip = MotionProfile::to_position({}, 10, round_limits);
  for (double t = 0.0625; t < 8; t += 0.0625) {
    const auto again = MotionProfile::to_position(trip.at(t), 10, round_limits);
    EXPECT_NEAR(again.duration(), trip.duration() - t, 1e-4) << t;
    EXPECT_EQ(again.end(), trip.end());
  }
}

TEST(MotionProfile, StandsWhereItIsSentToWhereItStands) {
  const auto trip = MotionProfile::to_position({5, 0, 0}, 5, round_limits);
  EXPECT_EQ(trip.duration(), 0);
  EXPECT_EQ(trip.at(1), (MotionState{5, 0, 0}));
  EXPECT_EQ(MotionProfile::resting_at(-3).at(7), (MotionState{-3, 0, 0}));
}

TEST(MotionProfile, OfSineSquaredRampsHasItsHighestAccelerationInTheMiddle) {
  MotionLimits limits = round_limits;
  limits.type = ProfileType::sine_squared;
  limits.jerk = {};
  const auto ramp = MotionProfile::to_velocity({}, 2, limits);
  const double half = ramp.duration() / 2;
  EXPECT_NEAR(ramp.duration(), 3.14159265358979, exact) << "pi/2 times that of a linear ramp";
  expect_state(ramp.at(half), {half * (1 - 2 / 3.14159265358979), 1, 1});
  expect_state(ramp.end(), {ramp.duration(), 2, 0});
}

TEST(MotionProfile, OfJerkFreeRampsStartsWithoutJerk) {
  MotionLimits limits = round_limits;
  limits.type = ProfileType::jerk_free;
  limits.jerk = {};
  const auto ramp = MotionProfile::to_velocity({}, 2, limits);
  EXPECT_NEAR(ramp.duration(), 3.75, exact) << "15/8 times that of a linear ramp";
  EXPECT_NEAR(ramp.at(1.875).acceleration, 1, exact);
  EXPECT_LT(ramp.at(0.001).acceleration, 1e-5);
  expect_state(ramp.end(), {3.75, 2, 0});
}

// Properties.

struct Draw {
  std::mt19937 engine;
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  MotionLimits limits() {
    static constexpr ProfileType types[] = {ProfileType::linear,       ProfileType::sine_squared,
                                            ProfileType::jerk_free,    ProfileType::jerk_limited,
                                            ProfileType::jerk_limited, ProfileType::jerk_limited};
    MotionLimits limits{
        .velocity = between(0.1, 10),
        .acceleration = between(0.2, 2),
        .deceleration = between(0.2, 2),
        .jerk = {between(0.3, 4), between(0.3, 4), between(0.3, 4), between(0.3, 4)},
        .type = types[engine() % std::size(types)]};
    if (engine() % 8 == 0) limits.jerk = {};
    return limits;
  }
};

/// Within the limits at all times, and without a jump: each step follows from the one before.
void expect_within_limits(const MotionProfile& trip, const MotionLimits& limits) {
  const double accelerations = std::max(limits.acceleration, limits.deceleration) + 1e-6;
  const auto& jerk = limits.jerk;
  const double jerk_max = std::max({jerk.start_acceleration, jerk.end_acceleration,
                                    jerk.start_deceleration, jerk.end_deceleration});
  const bool has_jerk = jerk_max > 0 && limits.type != ProfileType::linear;
  constexpr int steps = 400;
  const double step = trip.duration() / steps;
  MotionState before = trip.at(0);
  for (int i = 1; i <= steps; ++i) {
    const MotionState now = trip.at(step * i);
    ASSERT_LE(std::abs(now.velocity), limits.velocity + 1e-6);
    ASSERT_LE(std::abs(now.acceleration), accelerations);
    ASSERT_LE(std::abs(now.velocity - before.velocity), accelerations * step + 1e-9);
    ASSERT_LE(std::abs(now.position - before.position), limits.velocity * step + 1e-6);
    if (has_jerk) {
      ASSERT_LE(std::abs(now.acceleration - before.acceleration), jerk_max * step + 1e-6);
    }
    before = now;
  }
}

TEST(MotionProfileProperties, NeverExceedsALimitAndEndsExactlyAtItsTarget) {
  Draw draw{std::mt19937(417)};
  for (int i = 0; i < 300; ++i) {
    const MotionLimits limits = draw.limits();
    const double target = draw.between(-60, 60);
    const double end_velocity = i % 3 == 0 ? draw.between(0, limits.velocity) : 0;
    const auto trip = MotionProfile::to_position({}, target, limits, end_velocity);
    ASSERT_NO_FATAL_FAILURE(expect_within_limits(trip, limits)) << i;
    ASSERT_EQ(trip.at(trip.duration()).position, target);
    ASSERT_LE(std::abs(trip.end().velocity), end_velocity);
    const MotionState nearly = trip.at(trip.duration() * (1 - 1e-12));
    ASSERT_NEAR(nearly.position, target, 1e-6) << "no jump at the end";
    ASSERT_NEAR(nearly.velocity, trip.end().velocity, 1e-6);
  }
}

TEST(MotionProfileProperties, TakesAnyTargetAtAnyTime) {
  Draw draw{std::mt19937(4174)};
  for (int i = 0; i < 300; ++i) {
    const MotionLimits limits = draw.limits();
    const auto first = MotionProfile::to_position({}, draw.between(-60, 60), limits);
    const MotionState then = first.at(draw.between(0, first.duration()));
    const double target = draw.between(-60, 60);
    const auto second = MotionProfile::to_position(then, target, limits);
    ASSERT_NO_FATAL_FAILURE(expect_within_limits(second, limits)) << i;
    ASSERT_EQ(second.end(), (MotionState{target, 0, 0}));
    const auto stop = MotionProfile::to_velocity(then, 0, limits);
    ASSERT_NO_FATAL_FAILURE(expect_within_limits(stop, limits)) << i;
    ASSERT_EQ(stop.end().velocity, 0);
  }
}

TEST(MotionProfileProperties, ReachesWithoutTurningRoundWhatItSaysThatItCanReach) {
  Draw draw{std::mt19937(1001)};
  int reachable = 0;
  for (int i = 0; i < 300; ++i) {
    const MotionLimits limits = draw.limits();
    const auto first = MotionProfile::to_position({}, 60, limits);
    const MotionState then = first.at(draw.between(0, first.duration()));
    const double target = draw.between(then.position, 70);
    if (!MotionProfile::can_reach(then, target, limits)) continue;
    ++reachable;
    const auto second = MotionProfile::to_position(then, target, limits);
    for (double t = 0; t < second.duration(); t += second.duration() / 200) {
      ASSERT_GE(second.at(t).velocity, -1e-6) << i;
      ASSERT_LE(second.at(t).position, target + 1e-6) << i;
    }
  }
  EXPECT_GT(reachable, 100);
}

}  // namespace
}  // namespace canvoy::cia417::motion_profile_test
