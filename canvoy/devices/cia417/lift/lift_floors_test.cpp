#include "canvoy/devices/cia417/lift/lift_floors.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::cia417::lift_floors_test {
namespace {

constexpr std::array<std::int32_t, 4> positions = {0, 4'000'000, 7'000'000, 10'000'000};
constexpr LiftFloors floors(positions, 10'000);

MotionStatus standing_at(std::int32_t position) {
  return {.available = true, .position_micrometre = position};
}
MotionStatus moving(std::int32_t velocity, std::int32_t stops_at) {
  return {.available = true,
          .standing = false,
          .velocity_micrometre_per_second = velocity,
          .stopping_position_micrometre = stops_at};
}

TEST(LiftFloors, OfTwoThatAreAsNearTheUpperOneIsTheNearest) {
  EXPECT_EQ(floors.nearest(-500'000), 1);
  EXPECT_EQ(floors.nearest(1'999'999), 1);
  EXPECT_EQ(floors.nearest(2'000'000), 2);
  EXPECT_EQ(floors.nearest(3'000'000), 2);
  EXPECT_EQ(floors.nearest(12'000'000), 4);
}

TEST(LiftFloors, ACarStandsAtAFloorWithinTheTolerance) {
  EXPECT_EQ(floors.at(standing_at(4'010'000)), 2);
  EXPECT_EQ(floors.at(standing_at(4'010'001)), 0);
  EXPECT_EQ(floors.at(standing_at(3'990'000)), 2);
  EXPECT_EQ(floors.at(standing_at(3'989'999)), 0);
}

TEST(LiftFloors, ACarThatMovesOrIsNotHeardStandsAtNone) {
  MotionStatus motion = standing_at(4'000'000);
  motion.standing = false;
  EXPECT_EQ(floors.at(motion), 0);
  motion = standing_at(4'000'000);
  motion.available = false;
  EXPECT_EQ(floors.at(motion), 0);
}

TEST(LiftFloors, ACarReachesTheFirstFloorOnItsWayThatItCanStopAt) {
  EXPECT_EQ(floors.reachable(moving(1'000'000, 4'010'000), Direction::up, 1), 2);
  EXPECT_EQ(floors.reachable(moving(1'000'000, 4'010'001), Direction::up, 1), 3);
  EXPECT_EQ(floors.reachable(moving(-1'000'000, 3'990'000), Direction::down, 4), 2);
  EXPECT_EQ(floors.reachable(moving(-1'000'000, 3'989'999), Direction::down, 4), 1);
}

TEST(LiftFloors, ACarThatHasJustLeftAFloorDoesNotReachItAgain) {
  EXPECT_EQ(floors.reachable(moving(0, 4'000'000), Direction::up, 2), 3);
  EXPECT_EQ(floors.reachable(moving(0, 4'000'000), Direction::down, 2), 1);
  EXPECT_EQ(floors.reachable(moving(0, 4'000'000), Direction::up, 0), 2);
}

TEST(LiftFloors, NoCarReachesMoreThanTheLastFloor) {
  EXPECT_EQ(floors.reachable(moving(1'000'000, 11'000'000), Direction::up, 4), 4);
  EXPECT_EQ(floors.reachable(moving(-1'000'000, -1'000'000), Direction::down, 1), 1);
}

TEST(LiftFloors, TheNearestFloorWithADoorIsAskedFromHereOnAndBelowFirst) {
  const auto is = [](std::uint8_t a, std::uint8_t b) {
    return [a, b](std::uint8_t floor) { return floor == a || floor == b; };
  };
  EXPECT_EQ(floors.nearest_where(2, is(2, 3)), 2);
  EXPECT_EQ(floors.nearest_where(2, is(1, 3)), 1);
  EXPECT_EQ(floors.nearest_where(2, is(4, 4)), 4);
  EXPECT_EQ(floors.nearest_where(2, is(0, 5)), 2) << "none has one";
  EXPECT_EQ(floors.next_where(2, Direction::up, is(1, 4)), 4);
  EXPECT_EQ(floors.next_where(2, Direction::down, is(1, 4)), 1);
  EXPECT_EQ(floors.next_where(2, Direction::down, is(3, 4)), 2) << "none has one on the way";
}

}  // namespace
}  // namespace canvoy::cia417::lift_floors_test
