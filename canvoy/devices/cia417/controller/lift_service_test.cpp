// The services of a lift that keys ask for, and its faults.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"

namespace canvoy::cia417::lift_service_test {
namespace {

constexpr auto idle = LiftPhase::idle;
constexpr auto driving = LiftPhase::driving;
constexpr auto open = LiftPhase::open;

class LiftServiceTest : public LiftBenchTest {};

// Fire service.

TEST_F(LiftServiceTest, AFireAlarmCallsTheCarToTheFireFloor) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 5; }));
  bench.turn(SpecialFunction::fire_service_enable);
  EXPECT_EQ(lift.service(), LiftService::fire_recall);
  EXPECT_EQ(bench.told("400#05 07 01 00 F1 00"), 1u) << "calls are taken back";
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving && lift.target() == 1; }));
  EXPECT_EQ(bench.doors.open_steps[0], 0) << "it turned without opening";
  ASSERT_TRUE(bench.run_to(1, open));
  bench.run_for(120s);
  EXPECT_EQ(lift.phase(), open) << "and stays there";
  bench.press("02 01 01 04 10 01");
  bench.step();
  EXPECT_EQ(bench.told("400#02 01 01 04 10 00"), 1u) << "no call is taken";
  EXPECT_EQ(bench.told("400#43 04 01 FF F0 01"), 1u) << "fire";
  EXPECT_FALSE(lift.takes_hall_calls());
  bench.turn(SpecialFunction::fire_service_enable, false);
  EXPECT_EQ(lift.service(), LiftService::normal);
  bench.press("02 01 01 04 10 01");
  ASSERT_TRUE(bench.run_to(4, open));
}

TEST_F(LiftServiceTest, TheFireBrigadeDrivesByCarCallsAndOpensByTheButton) {
  bench.turn(SpecialFunction::fire_service);
  ASSERT_TRUE(bench.run_to(1, open));
  bench.step();
  EXPECT_EQ(lift.service(), LiftService::fire_brigade);
  bench.press("05 06 01 00 11 01");
  bench.run_for(30s);
  EXPECT_EQ(lift.phase(), open) << "doors close while the button is held";
  bench.turn(SpecialFunction::door_close);
  bench.run_for(1s);
  bench.turn(SpecialFunction::door_close, false);
  ASSERT_TRUE(bench.run_to(1, open)) << "it was let go too early";
  bench.turn(SpecialFunction::door_close);
  ASSERT_TRUE(bench.run_to(6, idle));
  bench.turn(SpecialFunction::door_close, false);
  bench.run_for(30s);
  EXPECT_EQ(bench.doors.open_steps[0], 0) << "it does not open by itself";
  bench.turn(SpecialFunction::door_open);
  ASSERT_TRUE(bench.run_to(6, open));
  bench.turn(SpecialFunction::door_open, false);
  bench.press("02 01 01 03 10 01");
  bench.run_for(5s);
  EXPECT_TRUE(bench.at(6)) << "hall calls are not answered";
  bench.turn(SpecialFunction::fire_service, false);
  EXPECT_EQ(lift.service(), LiftService::fire_recall) << "back to the fire floor";
  ASSERT_TRUE(bench.run_to(1, open));
  bench.step();
  EXPECT_EQ(lift.service(), LiftService::normal);
}

TEST_F(LiftServiceTest, UnderTheFireBrigadeACallToWhereTheCarStandsOpensNothing) {
  bench.turn(SpecialFunction::fire_service);
  ASSERT_TRUE(bench.run_to(1, open));
  bench.step();
  bench.press("05 06 01 00 11 01");
  bench.turn(SpecialFunction::door_close);
  ASSERT_TRUE(bench.run_to(6, idle));
  bench.turn(SpecialFunction::door_close, false);
  bench.cable.clear();
  bench.press("05 06 01 00 11 01");
  bench.run_for(10s);
  EXPECT_EQ(lift.phase(), idle);
  EXPECT_EQ(bench.doors.open_steps[0], 0);
  EXPECT_EQ(bench.told("400#05 06 01 00 F1 00"), 1u) << "it is where it was called to";
}

TEST_F(LiftServiceTest, TheFireBrigadeIsCalledToTheFireFloorEachTime) {
  for (const SpecialFunction before :
       {SpecialFunction::fire_service, SpecialFunction::fire_service_enable,
        SpecialFunction::out_of_order}) {
    bench.turn(before);
    ASSERT_TRUE(bench.run_until([&] { return lift.phase() == open; }));
    bench.step();
    bench.turn(before, false);
    ASSERT_TRUE(bench.run_until([&] { return lift.service() == LiftService::normal; }));
    bench.press("05 06 01 00 11 01");
    ASSERT_TRUE(bench.run_to(6, idle));
    bench.turn(SpecialFunction::fire_service);
    EXPECT_EQ(lift.service(), LiftService::fire_recall) << static_cast<unsigned>(before);
    ASSERT_TRUE(bench.run_to(1, open));
    bench.step();
    EXPECT_EQ(lift.service(), LiftService::fire_brigade);
    bench.turn(SpecialFunction::fire_service, false);
    ASSERT_TRUE(bench.run_to(1, idle));
  }
}

// Other services.

TEST_F(LiftServiceTest, OutOfOrderLetsEverybodyOutAndStands) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 3; }));
  bench.turn(SpecialFunction::out_of_order);
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == open; }));
  EXPECT_LE(lift.floor(), 4);
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == idle; }));
  bench.press("05 07 01 00 11 01");
  bench.run_for(60s);
  EXPECT_EQ(lift.phase(), idle);
  EXPECT_EQ(bench.told("400#43 0A 01 FF F0 01"), 1u);
  bench.turn(SpecialFunction::out_of_order, false);
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftServiceTest, AnAttendantClosesTheDoors) {
  bench.turn(SpecialFunction::attendant_service);
  bench.press("02 01 01 03 10 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.press("05 07 01 00 11 01");
  bench.run_for(60s);
  EXPECT_EQ(lift.phase(), open);
  bench.turn(SpecialFunction::door_close);
  bench.turn(SpecialFunction::door_close, false);
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftServiceTest, VipBedAndSpecialServiceAnswerCarCallsAlone) {
  for (const SpecialFunction function :
       {SpecialFunction::vip_service, SpecialFunction::bed_passenger_service,
        SpecialFunction::special_service}) {
    bench.press("02 02 01 03 10 01");
    bench.step();
    bench.turn(function);
    bench.cable.clear();
    bench.press("02 01 01 04 10 01");
    bench.press("05 07 01 00 11 01");
    ASSERT_TRUE(bench.run_to(7, open));
    EXPECT_EQ(bench.told("400#02 01 01 04 10 00"), 1u) << "refused";
    bench.run_for(60s);
    EXPECT_EQ(lift.phase(), open) << "until it is told where to";
    bench.press("05 01 01 00 11 01");
    ASSERT_TRUE(bench.run_to(1, open));
    bench.turn(function, false);
    ASSERT_TRUE(bench.run_to(1, idle));
  }
}

TEST_F(LiftServiceTest, DoggingAndServiceRunMoveWhileAButtonIsHeld) {
  for (const SpecialFunction function :
       {SpecialFunction::dogging_service_enable, SpecialFunction::service_run}) {
    bench.turn(function);
    bench.turn(SpecialFunction::dogging_service_up);
    bench.run_for(1s);
    const std::int32_t speed = function == SpecialFunction::service_run ? 630'000 : 300'000;
    EXPECT_EQ(bench.car.motion.velocity_micrometre_per_second, speed);
    bench.turn(SpecialFunction::dogging_service_up, false);
    EXPECT_TRUE(bench.car.motion.standing);
    bench.press("05 07 01 00 11 01");
    bench.turn(SpecialFunction::dogging_service_down);
    bench.run_for(20s);
    EXPECT_TRUE(bench.car.motion.standing) << "not below the first floor";
    EXPECT_LE(bench.car.motion.position_micrometre, 0);
    EXPECT_GT(bench.car.motion.position_micrometre, -10'000);
    bench.turn(SpecialFunction::dogging_service_down, false);
    bench.turn(function, false);
    ASSERT_TRUE(bench.run_to(1, idle)) << "on a floor again";
  }
}

/// EN 81-20, 5.12.1.5: the roof of the car (floor 0) and the pit (here the panel of floor 1).
TEST_F(LiftServiceTest, TwoInspectionStationsThatAreOnMoveTheCarTogether) {
  bench.turn(SpecialFunction::service_run);
  bench.press("0E 13 01 01 10 81");
  bench.step();
  bench.turn(SpecialFunction::dogging_service_up);
  bench.run_for(1s);
  EXPECT_TRUE(bench.car.motion.standing) << "the pit does not agree";
  bench.press("0E 16 01 01 10 01");
  bench.run_for(1s);
  EXPECT_TRUE(bench.car.motion.standing) << "it wants down";
  bench.press("0E 16 01 01 10 00");
  bench.press("0E 15 01 01 10 01");
  bench.run_for(1s);
  EXPECT_EQ(bench.car.motion.velocity_micrometre_per_second, 630'000);
  bench.turn(SpecialFunction::dogging_service_up, false);
  bench.run_for(100ms);
  EXPECT_TRUE(bench.car.motion.standing);
  bench.press("0E 13 01 01 10 80");
  bench.turn(SpecialFunction::dogging_service_up);
  bench.run_for(1s);
  EXPECT_EQ(bench.car.motion.velocity_micrometre_per_second, 630'000) << "the pit is off";
}

/// One station is on, by a key on the roof of the car (floor 0); its buttons may be at another
/// panel, here that of floor 1.
TEST_F(LiftServiceTest, OfOneStationThatIsOnTheButtonsMayBeAtAnotherPanel) {
  bench.turn(SpecialFunction::service_run);
  bench.press("0E 15 01 01 10 01");
  bench.run_for(1s);
  EXPECT_EQ(bench.car.motion.velocity_micrometre_per_second, 630'000);
  bench.press("0E 15 01 01 10 00");
  bench.run_for(100ms);
  EXPECT_TRUE(bench.car.motion.standing);
}

TEST_F(LiftServiceTest, AtTheEndOfItsTravelACarThatRestsShortOfItDoesNotGoOnByItself) {
  bench.car.run_margin = 50'000;  // a careful estimate of its way to stand
  bench.turn(SpecialFunction::dogging_service_enable);
  bench.turn(SpecialFunction::dogging_service_up);
  bench.run_for(120s);
  EXPECT_EQ(bench.car.runs, 1u) << "it was told to go once, and to stop once";
  EXPECT_TRUE(bench.car.motion.standing);
  EXPECT_GT(bench.car.motion.position_micrometre, LiftBench::floors.back() - 60'000);
  bench.turn(SpecialFunction::dogging_service_up, false);
  bench.turn(SpecialFunction::dogging_service_up);
  bench.run_for(10s);
  EXPECT_EQ(bench.car.runs, 2u) << "by the button";
  bench.turn(SpecialFunction::dogging_service_up, false);
  bench.turn(SpecialFunction::dogging_service_down);
  bench.run_for(120s);
  EXPECT_EQ(bench.car.runs, 3u);
  EXPECT_LT(bench.car.motion.position_micrometre, 60'000);
}

TEST_F(LiftServiceTest, TheServiceThatMattersMoreWins) {
  bench.turn(SpecialFunction::vip_service);
  EXPECT_EQ(lift.service(), LiftService::vip);
  bench.turn(SpecialFunction::fire_service_enable);
  EXPECT_EQ(lift.service(), LiftService::fire_recall);
  bench.turn(SpecialFunction::out_of_order);
  EXPECT_EQ(lift.service(), LiftService::out_of_order);
  bench.turn(SpecialFunction::service_run);
  EXPECT_EQ(lift.service(), LiftService::service_run) << "EN 81-20, 5.12.1.5.2.1";
  bench.turn(SpecialFunction::out_of_order, false);
  EXPECT_EQ(lift.service(), LiftService::service_run);
  bench.turn(SpecialFunction::service_run, false);
  EXPECT_EQ(lift.service(), LiftService::fire_recall) << "its key is still turned";
}

TEST_F(LiftServiceTest, LoadTimeHoldsTheDoorsForLonger) {
  bench.turn(SpecialFunction::load_time_1);
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  bench.run_for(14900ms);
  EXPECT_EQ(lift.phase(), open);
  bench.run_for(200ms);
  EXPECT_EQ(lift.phase(), LiftPhase::closing);
}

/// Detectors that react to smoke as well as people do not hold doors (EN 81-73 and EN 81-72).
TEST_F(LiftServiceTest, SmokeInItsLightBarriersDoesNotKeepARecalledCarAtItsFloor) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open));
  bench.doors.obstructed = 0b01;
  bench.run_for(1s);
  bench.turn(SpecialFunction::fire_service_enable);
  bench.step();
  EXPECT_EQ(lift.phase(), LiftPhase::closing);
  EXPECT_TRUE(bench.doors.nudged) << "with little force, whatever the barrier says";
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving; }, 3s));
  ASSERT_TRUE(bench.run_to(1, open));
  bench.press("05 06 01 00 11 01");
  bench.turn(SpecialFunction::fire_service);
  bench.step();
  ASSERT_EQ(lift.service(), LiftService::fire_brigade);
  bench.turn(SpecialFunction::door_close);
  EXPECT_TRUE(bench.run_until([&] { return lift.phase() == idle; }, 4s));
  EXPECT_TRUE(bench.doors.nudged);
}

// Levelling.

TEST_F(LiftServiceTest, ACarThatSinksByItsPassengersComesBackToItsFloorWithOpenDoors) {
  for (const std::int32_t off : {-11'000, 11'000, -199'000}) {
    bench.press("05 07 01 00 11 01");
    ASSERT_TRUE(bench.run_to(7, open));
    bench.run_for(1100ms);
    bench.car.motion.position_micrometre += off;
    bench.step();
    EXPECT_FALSE(bench.car.motion.standing) << off;
    EXPECT_EQ(bench.car.target, LiftBench::floors[6]);
    EXPECT_EQ(lift.floor(), 7);
    ASSERT_TRUE(bench.run_to(7, open)) << off;
    EXPECT_EQ(lift.fault(), LiftFault::none);
    EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps) << "all the time";
    ASSERT_TRUE(bench.run_to(7, idle));
    bench.car.left_unlocked = false;
  }
}

TEST_F(LiftServiceTest, ACarThatIsNearEnoughOrBetweenFloorsIsNotLevelled) {
  for (const std::int32_t off : {-10'000, 10'000, -201'000}) {
    bench.press("05 07 01 00 11 01");
    ASSERT_TRUE(bench.run_to(7, open));
    bench.run_for(1100ms);
    bench.car.motion.position_micrometre += off;
    bench.step();
    EXPECT_TRUE(bench.car.motion.standing) << off;
    bench.car.motion.position_micrometre -= off;
    ASSERT_TRUE(bench.run_to(7, idle));
  }
}

TEST_F(LiftServiceTest, ACarThatLeavesTheDoorZoneWhileItLevelsStopsFast) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open));
  bench.run_for(1100ms);
  bench.car.is_stuck = true;
  bench.car.motion.position_micrometre -= 20'000;
  bench.step();
  ASSERT_FALSE(bench.car.motion.standing);
  bench.car.motion.position_micrometre -= 190'000;
  bench.step();
  EXPECT_EQ(lift.fault(), LiftFault::unlocked);
  EXPECT_EQ(bench.car.fast_stops, 1U);
  bench.car.left_unlocked = false;
}

TEST_F(LiftServiceTest, ALevellingThatDoesNotSucceedIsTriedOnceASecond) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open));
  bench.turn(SpecialFunction::door_open);
  bench.run_for(1100ms);
  bench.car.is_stuck = true;
  bench.car.motion.position_micrometre -= 20'000;
  unsigned tries = 0;
  for (int i = 0; i < 35; ++i) {
    bench.run_for(100ms);
    tries += bench.car.motion.standing ? 0 : 1;
    bench.car.stop();
  }
  EXPECT_EQ(tries, 4U);
  bench.car.left_unlocked = false;
}

// Faults.

TEST_F(LiftServiceTest, WithoutADriveItStandsTellsAndGoesOnAfterwards) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 4; }));
  bench.car.motion.available = false;
  bench.step();
  EXPECT_EQ(lift.phase(), LiftPhase::stopped);
  EXPECT_EQ(lift.fault(), LiftFault::motion);
  EXPECT_GE(bench.car.fast_stops, 1u);
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 01 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x400).substr(0, 18), "400#43 0A 01 FF F0");
  EXPECT_FALSE(lift.takes_hall_calls());
  bench.run_for(60s);
  EXPECT_EQ(bench.doors.open_steps[0], 0) << "between floors nobody gets out";
  bench.car.motion.available = true;
  bench.step();
  EXPECT_EQ(bench.cable.last(0x081), "081#00 00 00 00 00 00 00 00");
  ASSERT_TRUE(bench.run_to(7, open)) << "the call is not lost";
}

TEST_F(LiftServiceTest, ADoorThatIsNotLockedStopsTheCar) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 4; }));
  bench.doors.open_steps[0] = 1;
  bench.car.left_unlocked = false;
  lift.update();
  EXPECT_EQ(lift.phase(), LiftPhase::stopped);
  EXPECT_EQ(bench.car.fast_stops, 1u);
  bench.cable.run_for(0ms);
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 02 00 00 00 00");
  ASSERT_TRUE(bench.run_to(7, open)) << "it closes, and goes on";
}

TEST_F(LiftServiceTest, WithADoorThatDoesNotLockItTakesNoCallsOfAGroup) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 4; }));
  bench.doors.open_steps[0] = 1;
  bench.doors.jammed = 0b01;
  lift.update();
  EXPECT_EQ(lift.fault(), LiftFault::unlocked);
  for (int seconds = 0; seconds < 60; ++seconds) {
    bench.run_for(1s);
    EXPECT_FALSE(lift.takes_hall_calls()) << seconds;
  }
  EXPECT_EQ(lift.fault(), LiftFault::none) << "it tries to close its doors";
  bench.doors.jammed = 0;
  ASSERT_TRUE(bench.run_to(7, open));
  EXPECT_TRUE(lift.takes_hall_calls());
  bench.doors.jammed = 0b01;
  bench.run_for(45s);
  EXPECT_FALSE(lift.takes_hall_calls()) << "nor at a floor, after three tries";
  bench.car.left_unlocked = false;
}

TEST_F(LiftServiceTest, WithALostDoorItEndsAtTheNextFloor) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 3; }));
  bench.doors.faulty = 0b01;
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == LiftPhase::stopped; }));
  EXPECT_TRUE(bench.at(3) || bench.at(4));
  EXPECT_EQ(bench.car.fast_stops, 0u);
  EXPECT_EQ(bench.cable.last(0x081), "081#04 FF 21 03 00 00 00 00");
  bench.run_for(60s);
  EXPECT_EQ(lift.phase(), LiftPhase::stopped);
  bench.doors.faulty = 0;
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftServiceTest, WithABrokenLightBarrierDoorsCloseGentlyAndTheLiftServes) {
  bench.doors.unprotected = 0b01;
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_to(7, open));
  EXPECT_EQ(lift.fault(), LiftFault::none);
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == LiftPhase::closing; }));
  EXPECT_EQ(bench.doors.closing, DoorClosing::gentle);
  bench.run_for(500ms);
  bench.doors.obstructed = 0b01;  // the force limit
  ASSERT_TRUE(bench.run_to(7, open)) << "they give way";
  bench.doors.obstructed = 0;
  bench.doors.unprotected = 0;
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == LiftPhase::closing; }));
  EXPECT_EQ(bench.doors.closing, DoorClosing::normal);
}

TEST_F(LiftServiceTest, ALightBarrierThatBreaksWhileDoorsCloseSlowsThemDown) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == LiftPhase::closing; }));
  ASSERT_EQ(bench.doors.closing, DoorClosing::normal);
  bench.doors.unprotected = 0b01;
  bench.step();
  EXPECT_EQ(bench.doors.closing, DoorClosing::gentle);
  EXPECT_TRUE(bench.run_to(3, idle));
}

TEST_F(LiftServiceTest, WithoutALoadItDoesNotLeave) {
  bench.weighed.known = false;
  bench.press("05 07 01 00 11 01");
  bench.run_for(20s);
  EXPECT_TRUE(bench.at(1));
  EXPECT_EQ(lift.fault(), LiftFault::load);
  EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps) << "who is inside gets out";
  bench.weighed.known = true;
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftServiceTest, WhoIsInsideGetsOutAlsoWhereTheFaultComesWhileDoorsClose) {
  bench.press("05 03 01 00 11 01");
  ASSERT_TRUE(bench.run_to(3, open));
  ASSERT_TRUE(bench.run_to(3, LiftPhase::closing));
  bench.step();
  bench.weighed.known = false;
  bench.run_for(20s);
  EXPECT_EQ(lift.fault(), LiftFault::load);
  EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps);
}

TEST_F(LiftServiceTest, WhoIsInsideGetsOutAlsoWhereTheControllerIsResetInAFault) {
  bench.weighed.known = false;
  bench.cable.send("000#81 01");
  bench.cable.send("000#01 01");
  bench.run_for(20s);
  EXPECT_EQ(lift.fault(), LiftFault::load);
  EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps);
}

TEST_F(LiftServiceTest, NobodyIsLetOutWhileThePositionIsTold) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 3; }));
  bench.car.stop();
  bench.weighed.known = false;
  bench.step();
  EXPECT_EQ(lift.fault(), LiftFault::load);
  // The position unit, back on the bus, sends what it could not: past floor 3, to 200 mm above.
  for (const std::int32_t position : {5'800'000, 5'995'000, 6'000'000, 6'100'000, 6'200'000}) {
    bench.car.motion.position_micrometre = position;
    bench.step();
    bench.step();
  }
  bench.run_for(10s);
  EXPECT_EQ(bench.doors.open_steps[0], 0) << "there is no floor";
  bench.car.motion.position_micrometre = 6'000'000;
  bench.run_for(400ms);
  EXPECT_EQ(bench.doors.open_steps[0], 0);
  bench.run_for(3s);
  EXPECT_EQ(bench.doors.open_steps[0], BenchDoors::travel_steps);
}

TEST_F(LiftServiceTest, ADoorThatWasToldToOpenAndStuckIsToldToCloseBeforeTheCarLeaves) {
  bench.weighed.known = false;
  bench.doors.jammed = 0b01;
  bench.run_for(5s);
  ASSERT_EQ(bench.doors.direction[0], 1) << "to let people out";
  bench.weighed.known = true;
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.phase() == driving; }));
  EXPECT_EQ(bench.doors.direction[0], -1);
  bench.doors.jammed = 0;
  ASSERT_TRUE(bench.run_to(7, open));
}

TEST_F(LiftServiceTest, LeavingOperationalStopsTheCar) {
  bench.press("05 07 01 00 11 01");
  ASSERT_TRUE(bench.run_until([&] { return lift.floor() == 3; }));
  bench.cable.send("000#80 01");
  EXPECT_EQ(bench.car.fast_stops, 1u);
  bench.cable.send("000#01 01");
  ASSERT_TRUE(bench.run_to(7, open));
}

// Reset.

TEST_F(LiftServiceTest, AfterAResetCallsAreTakenAgainWhateverWasOnBefore) {
  for (const SpecialFunction key :
       {SpecialFunction::fire_service_enable, SpecialFunction::out_of_order}) {
    bench.turn(key);
    bench.run_for(1s);
    bench.cable.send("000#82 00");
    bench.run_for(100ms);
    bench.cable.send("000#01 00");
    bench.run_for(100ms);
    const auto floor = static_cast<std::uint8_t>(bench.at(4) ? 6 : 4);
    bench.press(floor == 4 ? "05 04 01 00 11 01" : "05 06 01 00 11 01");
    EXPECT_TRUE(bench.run_to(floor, open)) << static_cast<unsigned>(key);
    EXPECT_TRUE(bench.run_to(floor, idle));
  }
}

}  // namespace
}  // namespace canvoy::cia417::lift_service_test
