#include "canvoy/worlds/lift/referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::lift::referee_test {
namespace {

/// Two lifts of 1.6 m/s, 1 m/s2, 1.2 m/s3 and 1000 kg between five floors 3.5 m apart.
struct RefereeTest : testing::Test {
  Invariant get(InvariantKind kind, LiftNumber lift = 1) const {
    const std::vector<Invariant> all = sut.invariants();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Invariant& one) {
      return one.kind == kind && one.part == lift;
    });
    if (found != all.end()) return *found;
    ADD_FAILURE() << "no such invariant";
    return {};
  }
  Invariant common(InvariantKind kind) const { return get(kind, 0); }
  bool lists(InvariantKind kind) const {
    return std::ranges::any_of(sut.invariants(),
                               [kind](const Invariant& one) { return one.kind == kind; });
  }

  const Building building = uniform_building({.floors = 5, .lifts = 2});
  Referee sut{building};
};

LiftFacts at_m(double position_m, double speed_m_s = 0, double acceleration_m_s2 = 0) {
  return {.position_m = position_m, .speed_m_s = speed_m_s, .acceleration_m_s2 = acceleration_m_s2};
}
LiftFacts unlocked(LiftFacts facts) {
  facts.doors[0].locked = false;
  return facts;
}
LiftFacts open(LiftFacts facts, double open_m = 0.9, std::size_t door = 0) {
  facts.doors.at(door) = {.open_m = open_m, .locked = false};
  return facts;
}

TEST_F(RefereeTest, ALiftServesAndTrapsNobodyEachForItself) {
  sut.idled(1, 2min);
  sut.idled(2, 2min + 1s);
  sut.trapped(1, 2min + 1s);
  EXPECT_TRUE(get(InvariantKind::lift_serves, 1).held);
  EXPECT_FALSE(get(InvariantKind::lift_serves, 2).held);
  EXPECT_FALSE(get(InvariantKind::nobody_trapped, 1).held);
  EXPECT_FALSE(get(InvariantKind::nobody_trapped, 2).is_decided());
}

TEST_F(RefereeTest, APositionThatIsNotSoIsItsUnitsDoing) {
  LiftFacts facts = at_m(3.5);
  facts.position_lie_m = 0.2;
  sut.observe(Time(2s), 1, facts);
  EXPECT_TRUE(get(InvariantKind::real_position).held);
  facts.position_lie_m = 3.5;
  sut.observe(Time(3s), 1, facts);
  EXPECT_FALSE(get(InvariantKind::real_position).held);
  EXPECT_EQ(get(InvariantKind::real_position).worst, 3500);
}

TEST_F(RefereeTest, NothingIsBrokenOrDecidedBeforeAnythingHappens) {
  for (const Invariant& one : sut.invariants()) {
    EXPECT_TRUE(one.held);
    EXPECT_FALSE(one.is_decided());
  }
}

TEST_F(RefereeTest, NoCarMovesWithADoorUnlockedOutsideTheDoorZone) {
  sut.observe(Time(1s), 1, unlocked(at_m(3.301, 0.1)));  // 199 mm below the second floor
  EXPECT_TRUE(get(InvariantKind::closed_while_moving).held);
  sut.observe(Time(1100ms), 1, unlocked(at_m(3.29, 0.1)));
  EXPECT_FALSE(get(InvariantKind::closed_while_moving).held);
  EXPECT_NEAR(get(InvariantKind::closed_while_moving).worst, 0.1, 1e-9);
  EXPECT_TRUE(get(InvariantKind::closed_while_moving, 2).held);
}

TEST_F(RefereeTest, NoCarMovesWithADoorOpenOutsideTheDoorZone) {
  LiftFacts facts = at_m(5, -0.1);
  facts.doors[3] = {.open_m = 0.01, .locked = true};
  sut.observe(Time(1s), 2, facts);
  EXPECT_FALSE(get(InvariantKind::closed_while_moving, 2).held);
}

LiftFacts cut(LiftFacts facts) {
  facts.is_cut = facts.emergency_stop = true;
  return facts;
}

TEST_F(RefereeTest, ACarThatTheSafetyChainHasCutOffMayComeToAStandWithAnUnlockedDoor) {
  sut.observe(Time(1s), 1, at_m(5, 1.6));
  sut.observe(Time(1100ms), 1, cut(unlocked(at_m(5.1, 1.6))));
  sut.observe(Time(2100ms), 1, cut(unlocked(at_m(5.2, 0.1))));
  EXPECT_TRUE(get(InvariantKind::closed_while_moving).held);
  sut.observe(Time(2101ms), 1, cut(unlocked(at_m(5.2, 0.1))));
  EXPECT_FALSE(get(InvariantKind::closed_while_moving).held) << "after a second";
}

TEST_F(RefereeTest, ACarThatAFaultMovesFromItsStandIsStoppedWithinASecondToo) {
  LiftFacts stands = cut(unlocked(at_m(5)));
  stands.hindered = true;
  LiftFacts drifts = cut(unlocked(at_m(5, 0.3)));
  drifts.hindered = true;
  for (const Time at : {Time(1s), Time(30s), Time(31s)}) sut.observe(at, 1, stands);
  sut.observe(Time(32s), 1, drifts);
  EXPECT_TRUE(get(InvariantKind::closed_while_moving).held);
  sut.observe(Time(33'001ms), 1, drifts);
  EXPECT_FALSE(get(InvariantKind::closed_while_moving).held);
}

TEST_F(RefereeTest, ACarWithoutABrakeIsStoppedByItsSafetyGearWithinTwoSeconds) {
  LiftFacts drifts = cut(unlocked(at_m(5, 0.3)));
  drifts.hindered = drifts.is_unheld = true;
  sut.observe(Time(1s), 1, drifts);
  sut.observe(Time(3s), 1, drifts);
  EXPECT_TRUE(get(InvariantKind::closed_while_moving).held);
  sut.observe(Time(3'001ms), 1, drifts);
  EXPECT_FALSE(get(InvariantKind::closed_while_moving).held);
}

TEST_F(RefereeTest, OnlyACarThatNothingHoldsMayGetToItsBuffers) {
  LiftFacts unheld = at_m(-0.31, -1);
  unheld.is_unheld = true;
  sut.observe(Time(1s), 1, unheld);
  sut.observe(Time(2s), 1, at_m(-0.31));
  EXPECT_TRUE(get(InvariantKind::travel).held) << "it stands there";
  sut.observe(Time(3s), 1, at_m(0));
  sut.observe(Time(4s), 1, at_m(-0.31));
  EXPECT_FALSE(get(InvariantKind::travel).held);
}

TEST_F(RefereeTest, TheSafetyChainStopsNoCarWithoutAFault) {
  sut.observe(Time(1s), 1, cut(at_m(0)));
  sut.observe(Time(2s), 1, at_m(0));
  LiftFacts with_fault = cut(at_m(5, 1));
  with_fault.hindered = true;
  sut.observe(Time(3s), 1, with_fault);
  sut.observe(Time(4s), 1, at_m(5, 1));
  EXPECT_TRUE(get(InvariantKind::chain_stops).held) << "it stood, or a fault was there";
  for (const Time at : {Time(5s), Time(6s)}) sut.observe(at, 1, cut(at_m(5, 1)));
  EXPECT_FALSE(get(InvariantKind::chain_stops).held);
  EXPECT_EQ(get(InvariantKind::chain_stops).worst, 1);
}

TEST_F(RefereeTest, ACarWithAnOpenDoorKeepsWithin20MillimetresOfItsFloor) {
  sut.observe(Time(1s), 1, open(at_m(3.481)));
  EXPECT_TRUE(get(InvariantKind::levelled).held);
  EXPECT_NEAR(get(InvariantKind::levelled).worst, 19, 1e-6);
  LiftFacts with_fault = open(at_m(3.44));
  with_fault.hindered = true;
  for (const Time at : {Time(2s), Time(30s)}) sut.observe(at, 1, with_fault);
  for (const Time at : {Time(31s), Time(60s)}) sut.observe(at, 1, open(at_m(3.25)));
  EXPECT_TRUE(get(InvariantKind::levelled).held) << "a fault, and between floors";
  sut.observe(Time(61s), 1, open(at_m(3.479)));
  sut.observe(Time(70s), 1, open(at_m(3.479)));
  EXPECT_TRUE(get(InvariantKind::levelled).held) << "10 s to level";
  sut.observe(Time(71s), 1, open(at_m(3.479)));
  sut.observe(Time(72s), 1, open(at_m(3.479)));
  EXPECT_FALSE(get(InvariantKind::levelled).held);
}

TEST_F(RefereeTest, ADoorThatBeginsToOpenWhileAFaultMovesTheCarIsNotJudged) {
  sut.observe(Time(1s), 1, at_m(3.5));
  LiftFacts drifts = open(at_m(3.52, 0.1), 0.01);
  drifts.hindered = true;
  sut.observe(Time(2s), 1, drifts);
  EXPECT_TRUE(get(InvariantKind::opens_at_floor).held);
  sut.observe(Time(3s), 1, at_m(3.52));
  drifts.speed_m_s = 0;
  sut.observe(Time(4s), 1, drifts);
  EXPECT_FALSE(get(InvariantKind::opens_at_floor).held) << "in a fault, too, where it stands";
}

TEST_F(RefereeTest, ACarMayStandWithAnOpenDoorWhereItIs) {
  sut.observe(Time(1s), 1, open(at_m(3.5)));
  sut.observe(Time(2s), 1, open(at_m(3.49, 0.05)));  // levels
  EXPECT_TRUE(get(InvariantKind::closed_while_moving).held);
}

TEST_F(RefereeTest, NoDoorOpensWhereNoFloorIs) {
  sut.observe(Time(1s), 1, at_m(7.009));
  sut.observe(Time(2s), 1, open(at_m(7.009), 0.01));
  EXPECT_TRUE(get(InvariantKind::opens_at_floor).held);
  EXPECT_NEAR(get(InvariantKind::opens_at_floor).worst, 9, 1e-6);
  sut.observe(Time(3s), 1, at_m(7.011));
  sut.observe(Time(4s), 1, open(at_m(7.011), 0.01));
  EXPECT_FALSE(get(InvariantKind::opens_at_floor).held);
}

TEST_F(RefereeTest, ASecondDoorCountsAsTheFirstDoes) {
  sut.observe(Time(1s), 1, open(at_m(7)));
  sut.observe(Time(2s), 1, open(open(at_m(7.02)), 0.9, 1));
  EXPECT_FALSE(get(InvariantKind::opens_at_floor).held);
}

TEST_F(RefereeTest, AnOverloadedCarDoesNotLeave) {
  LiftFacts facts = at_m(0);
  facts.load_kg = 1101;
  sut.observe(Time(1s), 1, facts);
  facts.position_m = 0.2;  // within the door zone: it has not left
  sut.observe(Time(2s), 1, facts);
  EXPECT_TRUE(get(InvariantKind::no_overload).held);
  facts.position_m = 0.21;
  sut.observe(Time(3s), 1, facts);
  EXPECT_FALSE(get(InvariantKind::no_overload).held);
}

TEST_F(RefereeTest, ACarWithAsMuchAsItMayCarryLeaves) {
  LiftFacts facts = at_m(0);
  facts.load_kg = 1100;
  sut.observe(Time(1s), 1, facts);
  facts.position_m = 1;
  sut.observe(Time(2s), 1, facts);
  EXPECT_TRUE(get(InvariantKind::no_overload).held);
  EXPECT_TRUE(get(InvariantKind::no_overload).is_decided());
}

TEST_F(RefereeTest, ACarAtItsBuffersHasGoneTooFar) {
  sut.observe(Time(1s), 1, at_m(-0.298));
  EXPECT_TRUE(get(InvariantKind::travel).held);
  sut.observe(Time(2s), 1, at_m(-0.3));
  EXPECT_FALSE(get(InvariantKind::travel).held);
}

TEST_F(RefereeTest, SpeedAccelerationAndTravelStayWithinLimits) {
  sut.observe(Time(1s), 1, at_m(14.29, -1.67, 1.04));
  EXPECT_TRUE(get(InvariantKind::speed).held);
  EXPECT_TRUE(get(InvariantKind::acceleration).held);
  EXPECT_TRUE(get(InvariantKind::travel).held);
  sut.observe(Time(2s), 1, at_m(-0.31, -1.69, -1.06));
  EXPECT_FALSE(get(InvariantKind::speed).held);
  EXPECT_FALSE(get(InvariantKind::acceleration).held);
  EXPECT_FALSE(get(InvariantKind::travel).held);
}

TEST_F(RefereeTest, JerkIsTheChangeOfTheAcceleration) {
  sut.observe(Time(1s), 1, at_m(5, 1, 0));
  sut.observe(Time(1100ms), 1, at_m(5, 1, 0.12));
  EXPECT_TRUE(get(InvariantKind::jerk).held);
  EXPECT_NEAR(get(InvariantKind::jerk).worst, 1.2, 1e-9);
  sut.observe(Time(1200ms), 1, at_m(5, 1, -0.02));
  EXPECT_FALSE(get(InvariantKind::jerk).held);
}

TEST_F(RefereeTest, AnEmergencyStopMayBeHardButNotHarderThanASafetyGear) {
  LiftFacts facts = at_m(5, 1, -5);
  facts.emergency_stop = true;
  sut.observe(Time(1s), 1, at_m(5, 1, 0));
  sut.observe(Time(1100ms), 1, facts);
  EXPECT_TRUE(get(InvariantKind::acceleration).held);
  EXPECT_TRUE(get(InvariantKind::jerk).held);
  facts.acceleration_m_s2 = -12;
  sut.observe(Time(1200ms), 1, facts);
  EXPECT_FALSE(get(InvariantKind::acceleration).held);
}

/// A car that stands at the second floor, with a display that has named another one since `since`.
LiftFacts misnamed(Time since, double speed_m_s = 0) {
  LiftFacts facts = at_m(3.5, speed_m_s);
  facts.misnamed_since = since;
  return facts;
}

TEST_F(RefereeTest, ADisplayNamesTheFloorOfItsStandingCarWithinThreeSeconds) {
  sut.observe(Time(1s), 1, misnamed(Time(0s), 0.1));
  EXPECT_FALSE(lists(InvariantKind::shown_floor)) << "it moves";
  sut.observe(Time(10s), 1, misnamed(Time(0s)));
  sut.observe(Time(13s), 1, misnamed(Time(0s)));
  EXPECT_TRUE(get(InvariantKind::shown_floor).held) << "it has stood for 3 s";
  EXPECT_EQ(get(InvariantKind::shown_floor).worst, 3);
  sut.observe(Time(14s), 1, misnamed(never));
  sut.observe(Time(20s), 1, misnamed(Time(17s)));
  EXPECT_TRUE(get(InvariantKind::shown_floor).held);
  sut.observe(Time(20'001ms), 1, misnamed(Time(17s)));
  EXPECT_FALSE(get(InvariantKind::shown_floor).held);
}

TEST_F(RefereeTest, ADisplayThatWasNotToldInAFaultIsToldWhenTheCarGoesOn) {
  LiftFacts facts = misnamed(Time(0s));
  facts.hindered = true;
  sut.observe(Time(1s), 1, facts);
  sut.observe(Time(2s), 1, misnamed(Time(0s)));
  sut.observe(Time(1min), 1, misnamed(Time(0s)));
  EXPECT_FALSE(lists(InvariantKind::shown_floor));
  sut.observe(Time(61s), 1, misnamed(Time(0s), 0.5));
  sut.observe(Time(70s), 1, misnamed(Time(0s)));
  sut.observe(Time(74s), 1, misnamed(Time(0s)));
  EXPECT_FALSE(get(InvariantKind::shown_floor).held);
}

TEST_F(RefereeTest, ADarkDisplayNamesNoFloor) {
  sut.observe(Time(1s), 1, at_m(3.5));
  sut.observe(Time(1min), 1, at_m(3.5));
  EXPECT_FALSE(lists(InvariantKind::shown_floor));
}

constexpr CallKey up_at_3{.floor = 3, .direction = Direction::up};

TEST_F(RefereeTest, EachButtonIsAcknowledgedByItsLamp) {
  sut.button_pressed(Time(1s), up_at_3);
  sut.lamp_changed(Time(1500ms), up_at_3, true);
  EXPECT_TRUE(common(InvariantKind::call_acknowledged).held);
  EXPECT_DOUBLE_EQ(common(InvariantKind::call_acknowledged).worst, 0.5);
}

TEST_F(RefereeTest, AButtonThatNobodyAcknowledgesIsSeen) {
  sut.button_pressed(Time(1s), up_at_3);
  sut.look_at_calls(Time(3s), false);
  EXPECT_TRUE(common(InvariantKind::call_acknowledged).held);
  sut.look_at_calls(Time(4s), false);
  EXPECT_FALSE(common(InvariantKind::call_acknowledged).held);
}

TEST_F(RefereeTest, WhileAFaultHindersNoTimeRuns) {
  sut.button_pressed(Time(1s), up_at_3);
  sut.look_at_calls(Time(60s), true);
  sut.look_at_calls(Time(61s), false);
  EXPECT_TRUE(common(InvariantKind::call_acknowledged).held);
}

TEST_F(RefereeTest, ACallIsServedWithinItsTime) {
  sut.lamp_changed(Time(0s), up_at_3, true);
  sut.observe(Time(31min), 1, open(at_m(7)));
  sut.lamp_changed(Time(31min), up_at_3, false, CallEnd::served);
  EXPECT_FALSE(common(InvariantKind::call_served).held);
}

TEST_F(RefereeTest, ACallIsServedWhereADoorIsWideOpenAlone) {
  sut.lamp_changed(Time(0s), up_at_3, true);
  sut.observe(Time(60s), 1, open(at_m(7), 0.3));
  sut.lamp_changed(Time(60s), up_at_3, false, CallEnd::served);
  sut.observe(Time(61s), 2, open(at_m(3.5)));
  sut.look_at_calls(Time(80s), false);
  EXPECT_FALSE(common(InvariantKind::call_served).is_decided());
  EXPECT_TRUE(common(InvariantKind::no_call_lost).held);
  sut.look_at_calls(Time(81s), false);
  EXPECT_FALSE(common(InvariantKind::no_call_lost).held) << "20 s, and nobody got in";
}

TEST_F(RefereeTest, ADoorThatOpensSoonAfterItsLampWentOutServesTheCall) {
  sut.lamp_changed(Time(0s), up_at_3, true);
  sut.lamp_changed(Time(60s), up_at_3, false, CallEnd::served);
  sut.observe(Time(63s), 1, open(at_m(7)));
  sut.look_at_calls(Time(90s), false);
  EXPECT_DOUBLE_EQ(common(InvariantKind::call_served).worst, 63);
  EXPECT_TRUE(common(InvariantKind::no_call_lost).held);
}

TEST_F(RefereeTest, RidersAndThoseWhoGiveUpCount) {
  sut.rode(15min, false);
  sut.rode(60min, true);
  EXPECT_TRUE(common(InvariantKind::no_endless_ride).held);
  sut.rode(15min + 1s, false);
  EXPECT_FALSE(common(InvariantKind::no_endless_ride).held);
  EXPECT_TRUE(common(InvariantKind::nobody_gives_up).held);
  sut.gave_up();
  EXPECT_FALSE(common(InvariantKind::nobody_gives_up).held);
}

TEST_F(RefereeTest, ACallMayBeTakenBackForAReason) {
  sut.lamp_changed(Time(0s), up_at_3, true);
  sut.lamp_changed(Time(1s), up_at_3, false, CallEnd::fire_service);
  EXPECT_TRUE(common(InvariantKind::no_call_lost).held);
}

TEST_F(RefereeTest, ACallThatVanishesIsLost) {
  sut.lamp_changed(Time(0s), up_at_3, true);
  sut.lamp_changed(Time(1s), up_at_3, false, CallEnd::unexplained);
  EXPECT_FALSE(common(InvariantKind::no_call_lost).held);
  EXPECT_EQ(common(InvariantKind::no_call_lost).worst, 1);
}

TEST_F(RefereeTest, NobodyWaitsForEver) {
  sut.waited(40min, true);
  EXPECT_TRUE(common(InvariantKind::no_endless_wait).held);
  sut.waited(31min, false);
  EXPECT_FALSE(common(InvariantKind::no_endless_wait).held);
}

LiftFacts recalled(LiftFacts facts) {
  facts.fire = FireMode::recall;
  return facts;
}

TEST_F(RefereeTest, ARecalledCarStandsOpenAtTheFireFloorInTime) {
  sut.observe(Time(0min), 1, recalled(at_m(7)));
  sut.observe(Time(1min), 1, recalled(open(at_m(0))));
  sut.observe(Time(60min), 1, recalled(open(at_m(0))));
  EXPECT_TRUE(get(InvariantKind::fire_recall).held);
  EXPECT_DOUBLE_EQ(get(InvariantKind::fire_recall).worst, 60);
}

TEST_F(RefereeTest, ARecalledCarThatStaysAwayIsSeen) {
  sut.observe(Time(0min), 1, recalled(at_m(7)));
  sut.observe(Time(4min), 1, recalled(at_m(7)));
  EXPECT_FALSE(get(InvariantKind::fire_recall).held);
}

TEST_F(RefereeTest, ADoorThatWasToldToOpenBeforeTheAlarmOpens) {
  sut.observe(Time(0s), 1, unlocked(at_m(7)));
  sut.observe(Time(100ms), 1, recalled(unlocked(at_m(7))));
  sut.observe(Time(500ms), 1, recalled(open(at_m(7))));
  EXPECT_TRUE(get(InvariantKind::fire_doors).held);
  EXPECT_TRUE(get(InvariantKind::fire_doors).is_decided());
  sut.observe(Time(10s), 1, recalled(at_m(7)));
  sut.observe(Time(11s), 1, recalled(open(at_m(7))));
  EXPECT_FALSE(get(InvariantKind::fire_doors).held) << "but not once more";
}

TEST_F(RefereeTest, ARecalledCarOpensAtNoOtherFloor) {
  sut.observe(Time(0s), 1, recalled(at_m(7)));
  sut.observe(Time(1s), 1, recalled(open(at_m(7))));
  EXPECT_FALSE(get(InvariantKind::fire_doors).held);
}

LiftFacts of_brigade(LiftFacts facts, bool opens_by_hand = false) {
  facts.fire = FireMode::brigade;
  facts.opens_by_hand = opens_by_hand;
  return facts;
}

TEST_F(RefereeTest, UnderTheFireBrigadeADoorOpensByItsButtonAlone) {
  sut.observe(Time(0s), 1, of_brigade(at_m(7)));
  sut.observe(Time(5s), 1, of_brigade(open(at_m(7)), true));
  EXPECT_TRUE(get(InvariantKind::fire_buttons).held);
  EXPECT_TRUE(get(InvariantKind::fire_buttons).is_decided());
  sut.observe(Time(10s), 1, of_brigade(at_m(7)));
  sut.observe(Time(15s), 1, of_brigade(open(at_m(7))));
  EXPECT_FALSE(get(InvariantKind::fire_buttons).held);
  EXPECT_FALSE(lists(InvariantKind::fire_doors)) << "there was no recall";
}

TEST_F(RefereeTest, WhenTheFireBrigadeHasGoneTheCarReturnsToTheFireFloorFirst) {
  sut.observe(Time(0s), 1, of_brigade(at_m(7)));
  sut.observe(Time(5s), 1, at_m(7));
  sut.observe(Time(60s), 1, at_m(0));
  EXPECT_TRUE(get(InvariantKind::fire_recall).held);
  sut.observe(Time(61s), 1, at_m(3.5));
  sut.observe(Time(62s), 1, open(at_m(3.5)));
  EXPECT_TRUE(get(InvariantKind::fire_doors).held) << "it serves again";
}

TEST_F(RefereeTest, ACarThatOpensOnItsWayBackFromTheFireBrigadeIsSeen) {
  sut.observe(Time(0s), 1, of_brigade(at_m(7)));
  sut.observe(Time(5s), 1, at_m(7));
  sut.observe(Time(9s), 1, at_m(3.5));
  sut.observe(Time(10s), 1, open(at_m(3.5)));
  EXPECT_FALSE(get(InvariantKind::fire_doors).held);
}

TEST_F(RefereeTest, InARecallNoCallIsTakenAndUnderTheBrigadeThoseOfTheCar) {
  constexpr CallKey car_to_2{.lift = 1, .floor = 2};
  sut.observe(Time(0s), 1, of_brigade(at_m(7)));
  sut.observe(Time(2s), 1, of_brigade(at_m(7)));
  sut.lamp_changed(Time(2s), car_to_2, true);
  EXPECT_TRUE(get(InvariantKind::fire_calls).held);
  sut.lamp_changed(Time(2s), car_to_2, false);
  sut.observe(Time(3s), 1, recalled(at_m(7)));
  sut.lamp_changed(Time(3'100ms), car_to_2, true);
  EXPECT_TRUE(get(InvariantKind::fire_calls).held) << "the key has just been turned";
  sut.lamp_changed(Time(4s), car_to_2, true);
  EXPECT_FALSE(get(InvariantKind::fire_calls).held);
}

TEST_F(RefereeTest, LandingCallsAreTakenAsLongAsOneLiftHasNoFireService) {
  sut.observe(Time(0s), 1, recalled(at_m(7)));
  sut.observe(Time(0s), 2, at_m(7));
  sut.lamp_changed(Time(2s), up_at_3, true);
  EXPECT_FALSE(lists(InvariantKind::fire_calls));
  sut.lamp_changed(Time(3s), up_at_3, false);
  sut.observe(Time(3s), 2, of_brigade(at_m(7)));
  sut.lamp_changed(Time(5s), up_at_3, true);
  EXPECT_FALSE(get(InvariantKind::fire_calls).held);
}

TEST_F(RefereeTest, WhatBreaksIsToldOnce) {
  EXPECT_TRUE(sut.take_broken().empty());
  sut.observe(Time(1s), 2, at_m(5, 3));
  const std::vector<Invariant> broken = sut.take_broken();
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].kind, InvariantKind::speed);
  EXPECT_EQ(broken[0].part, 2);
  sut.observe(Time(2s), 2, at_m(5, 3));
  EXPECT_TRUE(sut.take_broken().empty());
}

}  // namespace
}  // namespace canvoy::lift::referee_test
