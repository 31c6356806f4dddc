// Faults of a building with lifts beside those of lift_single_fault_test.cpp; and runs with faults
// of a seed in which all invariants must hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_soak.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_fault_test {
namespace {

Invariant find(const LiftNetwork& network, InvariantKind kind) {
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.kind == kind) return invariant;
  }
  ADD_FAILURE() << "no such invariant";
  return {};
}

/// A car that is on its way up with one passenger when the fault begins at 14 s; another passenger
/// comes after the end of the fault at 40 s.
struct LiftFaultTest : testing::Test {
  LiftFaultTest() {
    description.arrivals = {{.at = Time(2s), .from = 1, .to = 8},
                            {.at = Time(60s), .from = 3, .to = 1}};
  }
  LiftNetwork& run(ScheduledFault fault) {
    fault.start = Time(14s);
    fault.duration = 40s;
    description.faults.faults = {fault};
    network = std::make_unique<LiftNetwork>(description);
    network->run_until(Time(4min));
    return *network;
  }
  LiftNetworkDescription description = standard_lift_network({.floors = 8});
  std::unique_ptr<LiftNetwork> network;
};

TEST_F(LiftFaultTest, ACarThatStandsDoesNotStartWithADeadEncoder) {
  description.arrivals = {{.at = Time(20s), .from = 1, .to = 8}};  // in the midst of the fault
  run({.kind = FaultKind::dead_encoder});
  EXPECT_EQ(broken(*network), "");
  EXPECT_TRUE(find(*network, InvariantKind::safe_stand).is_decided());
  EXPECT_EQ(network->summary().served, 1U);
}

/// Number of times that a node reported an error by its emergency object.
std::ptrdiff_t times_told(const LiftNetwork& network, NodeId node, std::uint16_t code) {
  return std::ranges::count_if(network.events(), [=](const LiftEvent& event) {
    const auto* const told = std::get_if<EmergencySeen>(&event.what);
    return told != nullptr && told->node == node && told->code == code;
  });
}

TEST_F(LiftFaultTest, AStuckButtonIsToldAgainByAPanelThatRestarts) {
  description.faults.faults = {
      {.kind = FaultKind::stuck_button, .start = Time(14s), .duration = 60s, .spot = 4},
      {.kind = FaultKind::lost_node, .start = Time(40s), .duration = 5s, .node = 24}};
  LiftNetwork sut(description);
  sut.run_until(Time(39s));
  EXPECT_EQ(times_told(sut, 24, 0xFF04), 1);
  sut.run_until(Time(4min));
  EXPECT_EQ(times_told(sut, 24, 0xFF04), 2);
  EXPECT_EQ(broken(sut), "");
}

TEST_F(LiftFaultTest, AButtonThatSticksWhileItsPanelHasNoPowerIsToldWhenItHas) {
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(14s), .duration = 20s, .node = 24},
      {.kind = FaultKind::stuck_button, .start = Time(20s), .duration = 60s, .spot = 4}};
  LiftNetwork sut(description);
  sut.run_until(Time(34s));
  EXPECT_EQ(times_told(sut, 24, 0xFF04), 0);
  sut.run_until(Time(45s));
  EXPECT_EQ(times_told(sut, 24, 0xFF04), 1);
}

TEST_F(LiftFaultTest, ANodeAloneOnItsPieceOfCableTellsOfTheWarningLevelWhenTheCableIsWhole) {
  const LiftNetwork& sut = run({.kind = FaultKind::cable_cut, .node = 1});
  EXPECT_EQ(times_told(sut, 1, 0x0010), 1);
  EXPECT_EQ(times_told(sut, 1, 0x8120), 1);
  EXPECT_EQ(times_told(sut, 2, 0x0010), 0) << "others are there to acknowledge";
}

// Faults that move a car without a command. It stands empty at the lowest floor, and its
// counterweight is 500 kg heavier.

TEST_F(LiftFaultTest, ACarWithoutABrakeIsCaughtTellsOfItAndServesWhenSomebodyHasMendedIt) {
  description.arrivals = {{.at = Time(20s), .from = 3, .to = 1}, {.at = Time(60s), .from = 3}};
  const LiftNetwork& sut = run({.kind = FaultKind::brake});
  EXPECT_EQ(broken(sut), "");
  EXPECT_EQ(times_told(sut, 2, 0xFF06), 1);
  EXPECT_TRUE(find(sut, InvariantKind::emergency_told).is_decided());
  EXPECT_TRUE(find(sut, InvariantKind::safe_stand).is_decided());
  EXPECT_EQ(sut.summary().served, 2U);
}

/// A drive's fault is reset every two seconds: this does not help without a hand at the safety
/// gear.
TEST_F(LiftFaultTest, AfterOverspeedOrUnintendedMovementTheCarStandsUntilAHandResetsIt) {
  for (const FaultKind kind : {FaultKind::runaway, FaultKind::brake}) {
    const bool runs_away = kind == FaultKind::runaway;
    description.arrivals = {{.at = Time(60s), .from = 3, .to = 1}};
    if (runs_away) description.arrivals.push_back({.at = Time(2s), .from = 1, .to = 8});
    description.faults.faults = {{.kind = kind, .start = Time(14s)}};
    LiftNetwork sut(description);
    sut.run_until(Time(20s));
    const LiftSnapshot caught = sut.snapshot().lifts[0];
    EXPECT_EQ(caught.speed_m_s, 0);
    sut.run_until(Time(10min));
    const LiftSnapshot later = sut.snapshot().lifts[0];
    // One car is empty; from the other one a technician lets the passenger out at the next floor.
    if (!runs_away) EXPECT_EQ(later.position_m, caught.position_m);
    EXPECT_LT(std::abs(later.position_m - caught.position_m), 1.8) << fault_name(kind);
    EXPECT_EQ(sut.snapshot().riding, 0U);
    EXPECT_EQ(later.mode, LiftMode::fault);
    EXPECT_EQ(times_told(sut, 2, runs_away ? 0xFF05 : 0xFF06), 1);
    EXPECT_EQ(times_told(sut, 2, 0), 0) << "the error is still there";
    EXPECT_EQ(broken(sut), "");
    EXPECT_EQ(sut.summary().served, 0U);
  }
}

/// With one person it is lighter than its counterweight: from the highest floor its motor takes it
/// up. The buffers are 0.3 m away, the final limit 0.1 m.
TEST_F(LiftFaultTest, ACarThatRanIntoAFinalLimitComesBackWhenSomebodyHasResetIt) {
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 8},
                          {.at = Time(70s), .from = 8, .to = 1},
                          {.at = Time(180s), .from = 8, .to = 1}};
  description.faults.faults = {{.kind = FaultKind::runaway, .start = Time(60s), .duration = 60s}};
  LiftNetwork sut(description);
  sut.run_until(Time(119s));
  const double beyond_m = sut.snapshot().lifts[0].position_m - description.building.top_m();
  EXPECT_GT(beyond_m, 0.1);
  EXPECT_LT(beyond_m, 0.3);
  // The end of the fault does not reset it.
  sut.run_until(Time(130s));
  EXPECT_GT(sut.snapshot().lifts[0].position_m - description.building.top_m(), 0.1);
  EXPECT_EQ(sut.snapshot().riding, 1U);
  sut.run_until(Time(8min));
  EXPECT_EQ(broken(sut), "");
  EXPECT_EQ(sut.snapshot().riding, 0U);
  EXPECT_EQ(sut.summary().served, 2U) << "and one was let out where he had got in";
}

TEST_F(LiftFaultTest, ACarOfWhichTheRopesHaveSlippedGoesToItsFloorsAgain) {
  const LiftNetwork& sut = run({.kind = FaultKind::rope_slip});
  EXPECT_EQ(broken(sut), "");
  EXPECT_GE(times_told(sut, 1, 0xFF04), 1) << "it stood short of its floor";
  EXPECT_TRUE(find(sut, InvariantKind::emergency_told).is_decided());
  EXPECT_EQ(sut.summary().served, 2U);
}

TEST_F(LiftFaultTest, ALockThatSpringsOpenStopsTheCarByTheSafetyChain) {
  description.faults.faults = {{.kind = FaultKind::door_lock, .start = Time(14s), .duration = 40s}};
  LiftNetwork sut(description);
  sut.run_until(Time(14s));
  const double at = sut.snapshot().lifts[0].position_m;
  ASSERT_GT(sut.snapshot().lifts[0].speed_m_s, 1.5);
  sut.run_until(Time(15s));
  // 25 kN stop 3,375 kg from 1.6 m/s within 0.2 m; a drive would need 0.64 m at 2 m/s2.
  EXPECT_EQ(sut.snapshot().lifts[0].speed_m_s, 0);
  EXPECT_LT(sut.snapshot().lifts[0].position_m - at, 0.4);
}

TEST_F(LiftFaultTest, SmokeInTheLightBarriersDoesNotDelayARecall) {
  description.arrivals = {{.at = Time(2s), .from = 5, .to = 8}};
  LiftNetwork before(description);
  while (before.snapshot().lifts[0].position_m < 1 ||
         before.snapshot().lifts[0].doors[0].open_share < 1) {
    ASSERT_LT(before.now(), Time(1min));
    before.run_until(before.now() + 100ms);
  }
  const Time alarm = before.now() + 100ms;
  double recalled_s[2] = {};
  for (const bool with_smoke : {false, true}) {
    description.faults.faults = {{.kind = FaultKind::fire_alarm, .start = alarm, .duration = 2min}};
    if (with_smoke) {
      description.faults.faults.push_back(
          {.kind = FaultKind::smoke, .start = before.now(), .duration = 2min});
    }
    LiftNetwork sut(description);
    sut.run_until(Time(4min));
    EXPECT_EQ(broken(sut), "");
    recalled_s[with_smoke ? 1 : 0] = find(sut, InvariantKind::fire_recall).worst;
  }
  EXPECT_NEAR(recalled_s[1], recalled_s[0], 3) << "doors close gently, and take 2.6 s more";
}

TEST_F(LiftFaultTest, ACarThatSinksByTenPeopleIsLevelledWithOpenDoors) {
  description.building.lifts[0].car.rope_stretch_um_per_kg = 30;
  description.people.fill_share = 1;
  description.arrivals.assign(10, {.at = Time(2s), .from = 1, .to = 8, .mass_kg = 75});
  LiftNetwork sut(description);
  sut.run_until(Time(4min));
  EXPECT_EQ(broken(sut), "");
  const Invariant levelled = find(sut, InvariantKind::levelled);
  EXPECT_GT(levelled.worst, 10) << "22.5 mm in all";
  EXPECT_LT(levelled.worst, 20);
  EXPECT_EQ(sut.summary().served, 10U);
}

TEST_F(LiftFaultTest, AFaultLastsThoughAnotherOfItsKindEnds) {
  description.faults.faults = {
      {.kind = FaultKind::dead_encoder, .start = Time(60s), .duration = 20s},
      {.kind = FaultKind::dead_encoder, .start = Time(70s), .duration = 60s},
      {.kind = FaultKind::fire_alarm, .start = Time(200s), .duration = 20s, .part = 0},
      {.kind = FaultKind::fire_alarm, .start = Time(210s), .duration = 60s}};
  LiftNetwork sut(description);
  sut.run_until(Time(81s));
  const double position_m = sut.snapshot().lifts[0].position_m;
  sut.run_until(Time(129s));
  EXPECT_EQ(sut.snapshot().lifts[0].position_m, position_m) << "its encoder is dead";
  sut.run_until(Time(269s));
  EXPECT_EQ(sut.snapshot().riding, 0U) << "the alarm goes on";
  sut.run_until(Time(10min));
  EXPECT_EQ(broken(sut), "");
}

TEST_F(LiftFaultTest, AFaultThatTakesOverFromOneOfItsKindIsToldOnce) {
  const ScheduledFault first{
      .kind = FaultKind::cable_cut, .start = Time(14s), .duration = 20s, .node = 2};
  ScheduledFault second = first;
  second.start = first.end();
  description.faults.faults = {first, second};
  network = std::make_unique<LiftNetwork>(description);
  network->run_until(Time(4min));
  EXPECT_EQ(broken(*network), "");
}

TEST_F(LiftFaultTest, NobodyMissesAHeartbeatThatNeverCameOrThatAnotherFaultHasTaken) {
  description.faults.faults = {
      {.kind = FaultKind::babbling_node, .start = Time{}, .duration = 20s},
      {.kind = FaultKind::cable_cut, .start = Time(100s), .duration = 20s, .node = 4},
      {.kind = FaultKind::lost_node, .start = Time(120s), .duration = 6s, .node = 16},
      {.kind = FaultKind::lost_node, .start = Time(200s), .duration = 20s, .node = 1},
      {.kind = FaultKind::cable_cut, .start = Time(220s), .duration = 20s, .node = 1}};
  LiftNetwork sut(description);
  sut.run_until(Time(6min));
  EXPECT_EQ(broken(sut), "");
}

TEST_F(LiftFaultTest, ACableIsCutInOnePlaceAtATime) {
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 8}};
  description.faults.faults = {
      {.kind = FaultKind::cable_cut, .start = Time(10s), .duration = 60s, .node = 22},
      {.kind = FaultKind::cable_cut, .start = Time(12s), .duration = 40s, .node = 4}};
  LiftNetwork sut(description);
  sut.run_until(Time(4min));
  EXPECT_EQ(broken(sut), "") << "behind landing panel 22 is nothing that a car needs";
}

TEST_F(LiftFaultTest, TheEventOfAFaultSaysWhereItIs) {
  description = standard_lift_network({.lifts = 2, .floors = 8});
  struct Expected {
    ScheduledFault fault;
    LiftNumber lift;
    std::size_t bus;
    NodeId node;
  };
  const Expected all[] = {{{.kind = FaultKind::lost_node, .part = 2}, 2, 1, 2},
                          {{.kind = FaultKind::lost_node, .part = 2, .node = 13}, 2, 1, 13},
                          {{.kind = FaultKind::cable_cut, .part = 1}, 1, 0, 1},
                          {{.kind = FaultKind::stuck_button, .part = 1, .spot = 4}, 1, 0, 24},
                          {{.kind = FaultKind::stuck_button, .part = 2}, 2, 1, 16},
                          {{.kind = FaultKind::light_barrier, .part = 2}, 2, 1, 9},
                          {{.kind = FaultKind::dead_encoder, .part = 1}, 1, 0, 4},
                          {{.kind = FaultKind::babbling_node, .part = 2}, 2, 1, 16},
                          {{.kind = FaultKind::finger_protector, .part = 2}, 2, 1, 6},
                          {{.kind = FaultKind::door_lock, .part = 2, .node = 6}, 2, 1, 6},
                          {{.kind = FaultKind::rope_sensor, .part = 1}, 1, 0, 13},
                          {{.kind = FaultKind::brake, .part = 2}, 2, 1, 2},
                          {{.kind = FaultKind::smoke, .part = 1}, 1, 0, 9},
                          {{.kind = FaultKind::fire_brigade, .part = 2}, 2, 1, 0},
                          {{.kind = FaultKind::fire_alarm, .part = 0}, 0, 0, 0},
                          {{.kind = FaultKind::lost_node, .part = 0}, 0, 2, 17},
                          {{.kind = FaultKind::babbling_node, .part = 0, .node = 2}, 0, 2, 2}};
  for (const Expected& expected : all) {
    description.faults.faults = {expected.fault};
    description.faults.faults[0].start = Time(1s);
    LiftNetwork sut(description);
    sut.run_until(Time(1s));
    const auto found = std::ranges::find_if(sut.events(), [](const LiftEvent& event) {
      return std::holds_alternative<FaultBegan>(event.what);
    });
    ASSERT_NE(found, sut.events().end());
    const FaultPlace place = std::get<FaultBegan>(found->what).place;
    EXPECT_EQ(place.part, expected.lift);
    EXPECT_EQ(place.bus, expected.bus) << fault_name(expected.fault.kind);
    EXPECT_EQ(place.node, expected.node) << fault_name(expected.fault.kind);
  }
}

/// Reports of a node by virtual inputs (6010h), with their times in tenths of a second.
struct Inputs {
  using Request = std::pair<Duration::rep, int>;
  static void add(void* self, Time now, ControllerId, const Frame& frame) {
    auto& inputs = *static_cast<Inputs*>(self);
    if (frame.id != 0x480U + inputs.node) return;
    inputs.requests.emplace_back((now - Time{}) / 100ms, frame.data[5] & 3);
  }
  NodeId node = 0;
  std::vector<Request> requests{};
};

TEST_F(LiftFaultTest, APanelWithoutPowerShowsNothing) {
  description.arrivals = {{.at = Time(2s), .from = 8, .to = 1}};
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(10s), .duration = 5s, .node = 28}};
  LiftNetwork sut(description);
  sut.run_until(Time(9'999ms));
  EXPECT_TRUE(sut.snapshot().landings.at(7).lamp_down);
  sut.run_until(Time(10s));
  EXPECT_FALSE(sut.snapshot().landings.at(7).lamp_down);
  sut.run_until(Time(4min));
  EXPECT_EQ(sut.summary().served, 1U);
  EXPECT_EQ(broken(sut), "");
}

TEST_F(LiftFaultTest, AButtonThatIsLetGoWithoutPowerIsNotPressedWhenThePowerComesBack) {
  constexpr NodeId panel = node_id::first_landing_panel + 2;  // of floor 3
  // Passengers press half a second after they have come, for 0.3 s.
  description.arrivals = {{.at = Time(13'400ms), .from = 3, .to = 1},
                          {.at = Time(80s), .from = 3, .to = 1}};
  description.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(14s), .duration = 500ms, .node = panel}};
  network = std::make_unique<LiftNetwork>(description);
  Inputs told{.node = panel};
  network->observe(0, {.context = &told, .on_frame = Inputs::add});
  network->run_until(Time(90s));
  const std::vector<Inputs::Request> expected = {{0, 0}, {139, 1}, {145, 0}, {805, 1}, {808, 0}};
  EXPECT_EQ(told.requests, expected);
}

TEST_F(LiftFaultTest, InAFireTheCarGoesToTheFireFloorAndEverybodyLeavesIt) {
  description.arrivals.pop_back();
  const LiftNetwork& sut = run({.kind = FaultKind::fire_alarm});
  EXPECT_EQ(broken(sut), "");
  EXPECT_TRUE(find(sut, InvariantKind::fire_recall).is_decided());
  EXPECT_EQ(sut.summary().served, 0U);
  EXPECT_EQ(sut.snapshot().riding, 0U);
}

Duration run_time() {
  return tries_all() ? soak_time : Duration(12min);
}

class LiftSeedTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LiftSeedTest, WhateverGoesWrongWhatMustHoldDoes) {
  LiftNetwork network(soak_network(GetParam(), run_time()));
  network.run_until(Time(run_time()));
  EXPECT_EQ(broken(network), "");
  EXPECT_GT(network.summary().served, 0U);
}
INSTANTIATE_TEST_SUITE_P(Seeds, LiftSeedTest,
                         testing::Range<std::uint64_t>(1, tries_all() ? 21 : 7));

class LiftPairSeedTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LiftPairSeedTest, WhereTwoFaultsMeetWhatMustHoldDoes) {
  LiftNetwork network(soak_network_of_pairs(GetParam(), run_time()));
  network.run_until(Time(run_time()));
  EXPECT_EQ(broken(network), "");
  EXPECT_GT(network.summary().served, 0U);
}
INSTANTIATE_TEST_SUITE_P(Seeds, LiftPairSeedTest,
                         testing::Range<std::uint64_t>(1, tries_all() ? 9 : 4));

}  // namespace
}  // namespace canvoy::lift::lift_fault_test
