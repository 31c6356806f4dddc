// The safety chain alone: 1.6 m/s, a door zone of 200 mm, levelling at 0.3 m/s (EN 81-20).
#include "canvoy/worlds/lift/safety_chain.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::safety_chain_test {
namespace {

using Trip = SafetyChain::Trip;

constexpr SafetySight travelling{.from_floor_m = 1.5, .speed_m_s = 1.6};
constexpr SafetySight standing{};

TEST(SafetyChain, IsClosedWhileDoorsAreLockedAndNothingIsWrong) {
  SafetyChain sut;
  sut.look(standing);
  EXPECT_TRUE(sut.is_closed());
  sut.look(travelling);
  EXPECT_TRUE(sut.is_closed());
  EXPECT_FALSE(sut.wants_gear());
}

TEST(SafetyChain, OpensWithADoorThatIsUnlockedInMotionAndClosesWithIt) {
  SafetyChain sut;
  SafetySight sight = travelling;
  sight.doors_are_locked = false;
  sut.look(sight);
  EXPECT_FALSE(sut.is_closed());
  EXPECT_EQ(sut.trip(), Trip::none) << "no hand is needed";
  EXPECT_FALSE(sut.wants_gear());
  sight.speed_m_s = 0;
  sut.look(sight);
  EXPECT_FALSE(sut.is_closed()) << "it does not start so";
  sight.doors_are_locked = true;
  sut.look(sight);
  EXPECT_TRUE(sut.is_closed());
}

TEST(SafetyChain, LetsACarLevelWithOpenDoorsInTheDoorZone) {
  struct Row {
    double from_floor_m;
    double speed_m_s;
    bool is_closed;
  };
  constexpr Row rows[] = {{0, 0, true}, {0.2, 0.3, true}, {0.2, 0.301, false}, {0.201, 0, false}};
  for (const Row& row : rows) {
    SafetyChain sut;
    sut.look({.from_floor_m = row.from_floor_m,
              .speed_m_s = row.speed_m_s,
              .doors_are_locked = false,
              .is_a_door_open = true});
    EXPECT_EQ(sut.is_closed(), row.is_closed) << row.from_floor_m << " m, " << row.speed_m_s;
    EXPECT_EQ(sut.trip(), Trip::none);
  }
}

TEST(SafetyChain, IsOpenAfterOverspeedUntilSomebodyResetsIt) {
  SafetyChain sut;
  SafetySight sight = travelling;
  sight.speed_m_s = 1.92;
  sut.look(sight);
  EXPECT_TRUE(sut.is_closed()) << "120 %";
  sight.speed_m_s = 1.921;
  sut.look(sight);
  EXPECT_FALSE(sut.is_closed());
  EXPECT_EQ(sut.trip(), Trip::overspeed);
  EXPECT_TRUE(sut.wants_gear());
  for (const SafetySight& later : {travelling, standing}) {
    sut.look(later);
    EXPECT_FALSE(sut.is_closed());
  }
  sut.reset_by_hand();
  sut.look(standing);
  EXPECT_TRUE(sut.is_closed());
}

TEST(SafetyChain, IsOpenAfterACarHasLeftItsFloorWithAnOpenDoorUntilSomebodyResetsIt) {
  SafetyChain sut;
  SafetySight sight{.from_floor_m = 0.2, .doors_are_locked = false, .is_a_door_open = true};
  sut.look(sight);
  sight.from_floor_m = 0.201;
  sut.look(sight);
  EXPECT_EQ(sut.trip(), Trip::unintended_movement);
  EXPECT_TRUE(sut.wants_gear());
  sut.look(standing);
  EXPECT_FALSE(sut.is_closed());
  sut.reset_by_hand();
  sut.look(standing);
  EXPECT_TRUE(sut.is_closed());
}

TEST(SafetyChain, IsOpenBehindAFinalLimitUntilSomebodyResetsIt) {
  SafetyChain sut;
  sut.look({.from_floor_m = 0.1, .beyond_m = 0.1});
  EXPECT_TRUE(sut.is_closed());
  sut.look({.from_floor_m = 0.101, .beyond_m = 0.101});
  EXPECT_EQ(sut.trip(), Trip::final_limit);
  EXPECT_FALSE(sut.wants_gear()) << "the brake stops it";
  sut.look({.from_floor_m = 0.15, .beyond_m = 0.15});
  EXPECT_FALSE(sut.is_closed());
  sut.reset_by_hand();
  sut.look({.from_floor_m = 0.15, .beyond_m = 0.15});
  EXPECT_TRUE(sut.is_closed()) << "so that the car can come back";
  sut.look(standing);
  sut.look({.from_floor_m = 0.101, .beyond_m = 0.101});
  EXPECT_EQ(sut.trip(), Trip::final_limit) << "each time anew";
}

TEST(SafetyChain, IsOpenWhileTheSafetyGearHasCaughtTheCar) {
  SafetyChain sut;
  sut.look({.gear_is_caught = true});
  EXPECT_EQ(sut.trip(), Trip::gear);
  EXPECT_FALSE(sut.is_closed());
  sut.reset_by_hand();
  sut.look({.gear_is_caught = true});
  EXPECT_FALSE(sut.is_closed()) << "it has to be pulled off";
}

TEST(SafetyChain, IsOpenBehindABrakeThatHasSlippedUntilATechnicianResetsIt) {
  SafetyChain sut;
  sut.look({.brake_slips = true});
  EXPECT_FALSE(sut.is_closed());
  EXPECT_EQ(sut.trip(), Trip::brake);
  EXPECT_FALSE(sut.wants_gear()) << "the car stands";
  sut.look(standing);
  sut.reset_by_hand();
  EXPECT_FALSE(sut.is_closed()) << "by anybody else";
  sut.look({.from_floor_m = 0.2, .doors_are_locked = false, .is_a_door_open = true});
  sut.look({.from_floor_m = 0.201, .doors_are_locked = false, .is_a_door_open = true});
  EXPECT_EQ(sut.trip(), Trip::unintended_movement) << "which matters more";
  EXPECT_TRUE(sut.wants_gear());
  sut.look(standing);
  sut.reset_by_hand();
  EXPECT_EQ(sut.trip(), Trip::brake);
  sut.reset_brake();
  EXPECT_TRUE(sut.is_closed());
}

TEST(SafetyChain, ThatIsBridgedSeesNothing) {
  SafetyChain sut({.is_bridged = true});
  sut.look({.from_floor_m = 1, .speed_m_s = 3, .doors_are_locked = false, .gear_is_caught = true});
  EXPECT_TRUE(sut.is_closed());
  EXPECT_FALSE(sut.wants_gear());
}

}  // namespace
}  // namespace canvoy::lift::safety_chain_test
