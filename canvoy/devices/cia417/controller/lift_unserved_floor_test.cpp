// A lift that passes floors where it has no door: no passenger is left behind a wall. It serves
// floors 1, 2 and 7 to 10.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_unserved_floor_test {
namespace {

using enum LiftPhase;

struct LiftUnservedFloorTest : testing::Test {
  LiftUnservedFloorTest() { bench.start(); }

  /// On the way from the one to the other, between floors 4 and 5 or so.
  void be_on_the_way(bool up) {
    if (!up) {
      bench.press("05 09 01 00 11 01");
      ASSERT_TRUE(bench.run_to(9, open));
      ASSERT_TRUE(bench.run_to(9, idle));
    }
    bench.press(up ? "05 09 01 00 11 01" : "05 01 01 00 11 01");
    ASSERT_TRUE(
        bench.run_until([&] { return lift.phase() == driving && lift.floor() == (up ? 4 : 5); }));
  }

  LiftBench bench{{}, 1, FloorSet::between(1, 2) | FloorSet::between(7, 10)};
  LiftController& lift = bench.lift;
};

TEST_F(LiftUnservedFloorTest, OutOfOrderLetsEverybodyOutAtTheNextFloorWithADoor) {
  be_on_the_way(true);
  bench.turn(SpecialFunction::out_of_order);
  EXPECT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftUnservedFloorTest, AndOnTheWayDownAsWell) {
  be_on_the_way(false);
  bench.turn(SpecialFunction::out_of_order);
  EXPECT_TRUE(bench.run_to(2, open));
}

TEST_F(LiftUnservedFloorTest, WithALoadThatIsNotKnownAnyLongerItEndsAtTheNextFloorWithADoor) {
  be_on_the_way(true);
  bench.weighed.known = false;
  ASSERT_TRUE(bench.run_until([&] { return lift.fault() == LiftFault::load; }));
  EXPECT_TRUE(bench.at(7));
  EXPECT_TRUE(bench.run_until([&] { return (bench.doors.status().open & 1U) != 0; }, 10s));
}

TEST(LiftAtAnUnservedFloor, OutOfOrderItGoesToTheNearestFloorWithADoor) {
  LiftBench bench{{}, 1, FloorSet::between(1, 2) | FloorSet::between(7, 10)};
  bench.car.motion.position_micrometre = LiftBench::floors[3];
  bench.start();
  bench.turn(SpecialFunction::out_of_order);
  EXPECT_TRUE(bench.run_to(2, open));
}

/// Panels and car come from two makers with different doors: the car has only the second one, which
/// exists at floor 5.
struct LiftWithoutTheDoorsOfItsPanels : testing::Test {
  LiftWithoutTheDoorsOfItsPanels() {
    bench.car.motion.position_micrometre = LiftBench::floors[4];
    bench.start();
  }
  LiftBench bench{{}, 1, FloorSet::between(1, 10), 0b10};
};

TEST_F(LiftWithoutTheDoorsOfItsPanels, StandsAtTheFireFloorUntilItIsReset) {
  bench.turn(SpecialFunction::fire_service_enable);
  EXPECT_TRUE(bench.run_to(1, idle));
  bench.turn(SpecialFunction::fire_service_enable, false);
  bench.run_for(120s);
  EXPECT_EQ(bench.lift.phase(), idle);
  EXPECT_EQ(bench.lift.fault(), LiftFault::none);
  EXPECT_EQ(bench.lift.service(), LiftService::fire_recall) << "nobody could get out";
  bench.cable.send("000#82 00");
  bench.cable.send("000#01 00");
  bench.run_for(100ms);
  bench.press("05 05 01 00 12 01");
  EXPECT_TRUE(bench.run_to(5, open));
}

TEST_F(LiftWithoutTheDoorsOfItsPanels, GoesOnFromACallThatItCannotAnswer) {
  bench.press("05 03 01 00 11 01");
  EXPECT_TRUE(bench.run_to(3, idle));
  bench.press("05 05 01 00 12 01");
  EXPECT_TRUE(bench.run_to(5, open));
}

TEST_F(LiftUnservedFloorTest, CallsToAFloorWithoutADoorAreRefused) {
  bench.press("05 04 01 00 11 01");
  bench.press("02 01 01 04 10 01");
  bench.run_for(30s);
  EXPECT_EQ(lift.phase(), idle);
  EXPECT_TRUE(bench.at(1));
}

}  // namespace
}  // namespace canvoy::cia417::lift_unserved_floor_test
