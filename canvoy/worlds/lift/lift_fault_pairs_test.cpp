// Two faults of a lift at once, at any time of a trip: the effects of one are not attributed to the
// other, and people are carried when both have ended.
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_fault_pairs_test {
namespace {

/// The car goes up to floor 5 and down again, from 14 s on.
LiftNetworkDescription building() {
  LiftNetworkDescription made = standard_lift_network({.floors = 6});
  made.people.holds_door = 0;
  made.arrivals = {{.at = Time(11s), .from = 1, .to = 5},
                   {.at = Time(30s), .from = 5, .to = 1},
                   {.at = Time(100s), .from = 2, .to = 6},
                   {.at = Time(140s), .from = 6, .to = 1}};
  return made;
}

/// `second` begins `after` after `first`.
void expect_all_to_hold(ScheduledFault first, ScheduledFault second, Duration after) {
  for (Time start(14s); start < Time(54s); start += tries_all() ? 2s : 8s) {
    LiftNetworkDescription description = building();
    first.start = start;
    second.start = start + after;
    description.faults.faults = {first, second};
    LiftNetwork network(description);
    network.run_until(Time(5min));
    EXPECT_EQ(broken(network), "") << "from " << in_seconds(start.time_since_epoch());
    // Passengers whom a recall has taken to the fire floor leave.
    EXPECT_GE(network.summary().served, 3U) << "from " << in_seconds(start.time_since_epoch());
  }
}

TEST(TwoFaultsOfALift, ABrakeThatHoldsNothingMovesACarWhoseChainIsOpen) {
  expect_all_to_hold({.kind = FaultKind::door_lock, .duration = 16s},
                     {.kind = FaultKind::brake, .duration = 40s}, 5s);
}

TEST(TwoFaultsOfALift, WhatNeitherMotorNorBrakeHoldsIsForTheBuffers) {
  expect_all_to_hold({.kind = FaultKind::runaway, .duration = 30s},
                     {.kind = FaultKind::brake, .duration = 24s}, 0s);
}

TEST(TwoFaultsOfALift, AMotorWithoutCurrentDoesNotRunAway) {
  expect_all_to_hold({.kind = FaultKind::door_lock, .duration = 8s},
                     {.kind = FaultKind::runaway, .duration = 24s}, 0s);
}

TEST(TwoFaultsOfALift, WhoLeavesACarInARecallHasNotBeenCarried) {
  expect_all_to_hold({.kind = FaultKind::fire_alarm, .duration = 11s},
                     {.kind = FaultKind::lost_node, .duration = 30s, .node = node_id::position},
                     0s);
}

TEST(TwoFaultsOfALift, AControllerThatComesBackKnowsThatTheRopesHaveSlipped) {
  expect_all_to_hold(
      {.kind = FaultKind::rope_slip, .duration = 12s},
      {.kind = FaultKind::lost_node, .duration = 20s, .node = node_id::lift_controller}, 14s);
}

/// Its count is off by what has slipped: with one fast stop it is known from which side, and no
/// trip goes past its target again, not even to the other side.
TEST(TwoFaultsOfALift, RopesThatSlipAtAWeakBrakeCostOneFastStopAlone) {
  for (Time start(56s); start <= Time(64s); start += 4s) {
    LiftNetworkDescription description = standard_lift_network({.floors = 6});
    description.faults.faults = {{.kind = FaultKind::weak_brake, .start = start, .duration = 15s},
                                 {.kind = FaultKind::rope_slip, .start = start, .duration = 7s}};
    LiftNetwork network(description);
    network.run_until(Time(10min));
    EXPECT_EQ(broken(network), "") << "from " << in_seconds(start.time_since_epoch());
  }
}

TEST(TwoFaultsOfALift, TheFireAlarmOutlastsTheFireBrigade) {
  LiftNetworkDescription description = building();
  description.faults.faults = {
      {.kind = FaultKind::fire_alarm, .start = Time(1min), .duration = 8min},
      {.kind = FaultKind::fire_brigade, .start = Time(2min), .duration = 2min}};
  LiftNetwork sut(description);
  sut.run_until(Time(8min));
  EXPECT_EQ(sut.snapshot().lifts.at(0).mode, LiftMode::fire_recall);
  sut.run_until(Time(10min));
  EXPECT_EQ(sut.snapshot().lifts.at(0).mode, LiftMode::normal);
  EXPECT_EQ(broken(sut), "");
}

/// Error registers of the emergencies, one after the other.
std::vector<unsigned> registers_told(const LiftNetwork& network) {
  std::vector<unsigned> told;
  for (const LiftEvent& event : network.events()) {
    const auto* const seen = std::get_if<EmergencySeen>(&event.what);
    if (seen != nullptr) told.push_back(seen->error_register);
  }
  return told;
}

TEST(TwoFaultsOfALift, OfOnePanelsButtonsOneSticksThoughAnotherIsFree) {
  LiftNetworkDescription description = standard_lift_network({.floors = 110});
  description.arrivals = {{.at = Time(40s), .from = 4, .to = 1}};  // presses the button, and
                                                                   // releases it
  description.faults.faults = {
      {.kind = FaultKind::stuck_button, .start = Time(10s), .duration = 20s, .spot = 3},
      {.kind = FaultKind::stuck_button, .start = Time(12s), .duration = 68s, .spot = 4}};
  LiftNetwork sut(description);
  sut.run_until(Time(70s));
  EXPECT_EQ(registers_told(sut), (std::vector{0x21U, 0x21U, 0x21U})) << "both stick, then one";
  sut.run_until(Time(90s));
  EXPECT_EQ(registers_told(sut), (std::vector{0x21U, 0x21U, 0x21U, 0U}));
}

TEST(AFaultAtTime0, OfTheBrakeIsToldAsOverspeedByADriveThatHasNotSeenTheCarStand) {
  LiftNetworkDescription description = building();
  description.faults.faults = {{.kind = FaultKind::brake, .duration = 10s}};
  LiftNetwork network(description);
  network.run_until(Time(5min));
  EXPECT_EQ(broken(network), "");
  EXPECT_EQ(network.summary().served, 4U);
}

/// Ten people of 75 kg in a car for 13: no further person would board.
TEST(AFullCar, PassesTheCallsOnItsWay) {
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  description.arrivals.assign(10, {.at = Time(11s), .from = 8, .to = 1});
  for (FloorNumber floor = 4; floor <= 6; ++floor) {
    description.arrivals.push_back({.at = Time(40s), .from = floor, .to = 1});
  }
  LiftNetwork network(description);
  network.run_until(Time(5min));
  EXPECT_EQ(network.summary().served, 13U);
  const auto is_full_start = [](const LiftEvent& event) {
    const auto* start = std::get_if<CarStarted>(&event.what);
    return start != nullptr && start->persons == 10;
  };
  EXPECT_EQ(std::ranges::count_if(network.events(), is_full_start), 1) << "from floor 8 to floor 1";
}

}  // namespace
}  // namespace canvoy::lift::lift_fault_pairs_test
