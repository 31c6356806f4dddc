// The trips of a lift: calls by the wire, a car of plain numbers.
#include "canvoy/devices/cia417/controller/lift_controller.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_controller_test {
namespace {

constexpr auto idle = LiftPhase::idle;
constexpr auto driving = LiftPhase::driving;
constexpr auto open = LiftPhase::open;

class LiftControllerTest : public LiftBenchTest {};

TEST_F(LiftControllerTest, WithoutCallsItStands) {
  bench.run_for(200s);
  EXPECT_EQ(lift.phase(), idle);
  EXPECT_TRUE(bench.at(1));
}

TEST_F(LiftControllerTest, ATripTakesItsTimes) {
  bench.press("02 02 01 04 10 01");
  const Time pressed = bench.cable.now;
  bench.step();
  EXPECT_EQ(lift.phase(), driving);
  EXPECT_EQ(lift.target(), 4);
  ASSERT_TRUE(bench.run_to(4, LiftPhase::opening));
  EXPECT_EQ(bench.cable.now - pressed, 9s) << "9 m at 1 m/s";
  ASSERT_TRUE(bench.run_to(4, open));
  EXPECT_EQ(bench.cable.now - pressed, 11s);
  ASSERT_TRUE(bench.run_to(4, LiftPhase::closing));
  EXPECT_EQ(bench.cable.now - pressed, 15s) << "4 s for who gets in";
  ASSERT_TRUE(bench.run_to(4, idle));
  EXPECT_EQ(bench.cable.now - pressed, 17s);
  EXPECT_EQ(lift.direction(), Direction::none);
}

TEST_F(LiftControllerTest, ACallWhereTheCarHasJustLeftDoesNotBringItBack) {
  bench.press("05 04 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving; }));
  EXPECT_EQ(lift.floor(), 2) << "the first where it can stop";
  bench.press("02 01 01 01 10 01");
  bench.step();
  EXPECT_EQ(lift.target(), 4);
  ASSERT_TRUE(bench.run_to(4, open));
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving; }));
  EXPECT_EQ(lift.floor(), 3);
  bench.press("02 02 01 04 10 01");
  bench.step();
  EXPECT_EQ(lift.target(), 1);
  EXPECT_TRUE(bench.run_to(1, open));
}

TEST_F(LiftControllerTest, PanelsSeeTheTrip) {
  bench.press("02 02 01 04 10 01");
  ASSERT_TRUE(bench.run_to(4, idle));
  EXPECT_EQ(bench.told("400#02 02 01 04 10 81"), 1u) << "acknowledged";
  EXPECT_EQ(bench.told("400#42 11 01 00 F0 01"), 1u) << "moves up";
  for (const char* floor :
       {"400#40 02 01 FF F0 01", "400#40 03 01 FF F0 01", "400#40 04 01 FF F0 01"}) {
    EXPECT_EQ(bench.told(floor), 1u);
  }
  EXPECT_EQ(bench.told("400#41 02 01 04 10 01"), 1u) << "the lantern says down";
  EXPECT_EQ(bench.told("400#44 02 01 04 10 05"), 1u) << "and the gong";
  EXPECT_EQ(bench.told("400#02 02 01 04 10 00"), 1u) << "served";
  EXPECT_EQ(bench.told("400#41 02 01 04 10 00"), 1u) << "out again";
}

TEST_F(LiftControllerTest, ItStopsOnItsWayForWhoComesInTime) {
  bench.press("05 09 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 4; }));
  bench.press("02 01 01 06 10 01");
  bench.press("02 01 01 03 10 01");
  ASSERT_TRUE(bench.run_to(6, open)) << "not back to 3";
  ASSERT_TRUE(bench.run_to(9, open));
  ASSERT_TRUE(bench.run_to(3, open));
}

TEST_F(LiftControllerTest, AFloorThatItCannotStopAtAnyMoreIsPassed) {
  bench.press("05 09 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return bench.car.motion.position_micrometre >= 5'600'000; }));
  bench.press("02 01 01 03 10 01");  // at 6 m; it takes 0.5 m
  ASSERT_TRUE(bench.run_to(9, open));
  ASSERT_TRUE(bench.run_to(3, open));
}

TEST_F(LiftControllerTest, TheOpenButtonAndTheLightBarrierHoldTheDoors) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.run_for(2900ms);
  bench.press("0E 09 01 00 10 01");
  bench.run_for(5s);
  EXPECT_EQ(lift.phase(), open);
  bench.press("0E 09 01 00 10 00");
  bench.run_for(2s);
  ASSERT_TRUE(bench.run_to(3, LiftPhase::closing));
  bench.run_for(500ms);
  bench.doors.obstructed = 0b01;
  bench.step();
  EXPECT_EQ(lift.phase(), LiftPhase::opening);
  bench.doors.obstructed = 0;
  ASSERT_TRUE(bench.run_to(3, open));
  bench.press("0E 0A 01 00 10 01");
  bench.step();
  EXPECT_EQ(lift.phase(), LiftPhase::closing) << "the close button";
}

TEST_F(LiftControllerTest, AfterTwentySecondsItNudges) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.doors.obstructed = 0b01;
  bench.run_for(19900ms);
  EXPECT_EQ(lift.phase(), open);
  ASSERT_TRUE(bench.run_to(3, LiftPhase::closing));
  EXPECT_TRUE(bench.doors.nudged);
  ASSERT_TRUE(bench.run_to(3, idle)) << "whatever the light barrier says";
}

TEST_F(LiftControllerTest, AStuckOpenButtonHoldsNobodyForEver) {
  bench.press("0E 09 01 00 10 01");
  ASSERT_TRUE(bench.run_to(1, open));
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  ASSERT_TRUE(bench.run_to(3, idle));
  bench.run_for(10s);
  EXPECT_EQ(lift.phase(), idle);
}

TEST_F(LiftControllerTest, AnOverloadedCarDoesNotLeave) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.weighed.overload = true;
  bench.press("05 07 01 00 11 01");
  bench.run_for(60s);
  EXPECT_EQ(lift.phase(), open);
  EXPECT_EQ(bench.told("400#43 03 01 00 F0 01"), 1u);
  bench.weighed.overload = false;
  ASSERT_TRUE(bench.run_to(3, LiftPhase::closing));
  bench.weighed.overload = true;  // another person gets in
  bench.step();
  EXPECT_EQ(lift.phase(), LiftPhase::opening);
  bench.weighed.overload = false;
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftControllerTest, AFullCarPassesLandings) {
  bench.weighed.full = true;
  bench.press("05 07 01 00 11 01");
  bench.press("02 01 01 04 10 01");
  ASSERT_TRUE(bench.run_to(7, open));
  bench.weighed.full = false;
  ASSERT_TRUE(bench.run_to(4, open));
}

TEST_F(LiftControllerTest, ItOpensTheDoorThatIsWanted) {
  bench.press("05 05 01 00 12 01");
  ASSERT_TRUE(bench.run_to(5, open));
  EXPECT_EQ(bench.doors.open_steps[0], 0);
  EXPECT_EQ(bench.doors.open_steps[1], BenchDoors::travel_steps);
  bench.press("02 01 01 05 10 01");
  ASSERT_TRUE(bench.run_until([&] { return bench.doors.open_steps[0] != 0; }))
      << "and the other one for who waits there";
}

TEST_F(LiftControllerTest, ADoorThatDoesNotCloseIsTriedAgain) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.doors.jammed = 0b01;
  bench.press("05 07 01 00 11 01");
  bench.run_for(60s);
  EXPECT_TRUE(bench.at(3));
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 11 00 00 00 00");
  bench.doors.jammed = 0;
  ASSERT_TRUE(bench.run_to(7, open));
  EXPECT_EQ(bench.cable.last(0x081), "081#00 00 00 00 00 00 00 00");
}

TEST_F(LiftControllerTest, ADoorThatDoesNotOpenIsPassedOver) {
  bench.doors.jammed = 0b01;
  bench.press("05 03 01 00 11 01");
  bench.press("05 05 01 00 12 01");
  ASSERT_TRUE(bench.run_to(5, open));
  EXPECT_NE(bench.told("081#04 FF 21 10 00 00 00 00"), 0u);
}

TEST_F(LiftControllerTest, ALateCallIsCancelledWithHallCallsDisabled) {
  bench.press("02 01 01 07 10 01");
  bench.run_for(3s);
  bench.press("0E 0D 01 00 10 81");
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == idle; }));
  EXPECT_FALSE(bench.at(7)) << "it ends at the next floor, without a call";
  EXPECT_EQ(bench.told("400#02 01 01 07 10 00"), 1u);
  EXPECT_FALSE(lift.takes_hall_calls());
}

TEST(LiftControllerParking, WithoutCallsItGoesToTheParkingFloor) {
  LiftBench bench({.parking_floor = 2});
  bench.start();
  bench.press("05 05 01 00 11 01");
  ASSERT_TRUE(bench.run_to(5, idle));
  bench.run_for(59s);
  EXPECT_TRUE(bench.at(5));
  ASSERT_TRUE(bench.run_to(2, idle));
  EXPECT_EQ(bench.doors.open_steps[0], 0) << "nobody wants to get out";
  bench.press("02 01 01 09 10 01");
  ASSERT_TRUE(bench.run_to(9, open));
}

TEST(LiftControllerParking, ACallOnTheWayToTheParkingFloorIsAnswered) {
  LiftBench bench({.parking_floor = 1});
  bench.start();
  bench.press("05 09 01 00 11 01");
  ASSERT_TRUE(bench.run_to(9, idle));
  ASSERT_TRUE(bench.run_until([&] { return bench.lift.floor() == 7; }));
  bench.press("02 02 01 05 10 01");
  ASSERT_TRUE(bench.run_to(5, open));
  EXPECT_FALSE(bench.car.left_unlocked);
}

}  // namespace
}  // namespace canvoy::cia417::lift_controller_test
