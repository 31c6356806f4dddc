// Fires, the fire brigade, and defective groups of lifts: the rules of a fire service hold, and a
// lift without its group serves alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_group_fault_test {
namespace {

bool is_decided(const LiftNetwork& network, InvariantKind kind) {
  const std::vector<Invariant> all = network.invariants();
  return std::any_of(all.begin(), all.end(), [kind](const Invariant& invariant) {
    return invariant.kind == kind && invariant.is_decided();
  });
}

/// Floors where doors opened within a time.
std::set<FloorNumber> opened(const LiftNetwork& network, Time from, Time until) {
  std::set<FloorNumber> floors;
  for (const LiftEvent& event : network.events()) {
    const auto* const doors = std::get_if<DoorsOpened>(&event.what);
    if (doors != nullptr && event.at >= from && event.at <= until) floors.insert(doors->floor);
  }
  return floors;
}

TEST(LiftFireTest, TheFireBrigadeGoesWhereItWantsAndNobodyElseIsServed) {
  LiftNetworkDescription description = standard_lift_network({.floors = 6});
  description.service.fire_floor = 2;
  description.arrivals = {{.at = Time(2s), .from = 1, .to = 6},
                          {.at = Time(100s), .from = 4, .to = 1},
                          {.at = Time(330s), .from = 3, .to = 1}};
  description.people.patience_least = description.people.patience_most = 60s;
  description.faults.faults = {
      {.kind = FaultKind::fire_brigade, .start = Time(14s), .duration = 290s}};
  LiftNetwork network(description);
  network.run_until(Time(400s));
  EXPECT_EQ(broken(network), "");
  for (const InvariantKind kind :
       {InvariantKind::fire_recall, InvariantKind::fire_doors, InvariantKind::fire_buttons}) {
    EXPECT_TRUE(is_decided(network, kind));
  }
  EXPECT_GE(opened(network, Time(40s), Time(300s)).size(), 3U) << "the floors that they search";
  EXPECT_EQ(network.summary().gave_up, 1U) << "who called in a fire";
  EXPECT_EQ(network.summary().served, 1U) << "who comes when it is over";
}

TEST(LiftFireTest, AnAlarmOfTheGroupCallsAllCars) {
  LiftNetworkDescription description = standard_lift_network({.lifts = 2, .floors = 5});
  description.faults.faults = {
      {.kind = FaultKind::fire_alarm, .start = Time(60s), .duration = 60s, .part = 0}};
  description.traffic.percent_in_5_minutes = 10;
  LiftNetwork network(description);
  network.run_until(Time(119s));
  for (const LiftSnapshot& lift : network.snapshot().lifts) {
    EXPECT_EQ(lift.mode, LiftMode::fire_recall);
    EXPECT_EQ(lift.nearest_floor, 1);
    EXPECT_GT(lift.doors[0].open_share, 0.9);
  }
  EXPECT_EQ(network.snapshot().riding, 0U);
  network.run_until(Time(4min));
  EXPECT_EQ(broken(network), "");
}

/// A node reports it on the bus of a group, the last one, within 5 s.
bool is_told(const LiftNetwork& network, std::uint16_t code, Time since) {
  const std::size_t bus = network.description().buses.size() - 1;
  return std::ranges::any_of(network.events(), [&](const LiftEvent& event) {
    const auto* const told = std::get_if<EmergencySeen>(&event.what);
    const bool is_it = told != nullptr && told->bus == bus && told->code == code;
    return is_it && event.at > since && event.at <= since + 5s;
  });
}

struct LiftGroupFaultTest : testing::TestWithParam<bool> {
  LiftNetwork& run(const ScheduledFault& fault) {
    LiftNetworkDescription description = standard_lift_network(
        {.lifts = 3, .floors = 6, .destination_control = GetParam(), .seed = 5});
    description.traffic.percent_in_5_minutes = 10;
    description.faults.faults = {fault};
    description.faults.faults[0].part = 0;
    description.faults.faults[0].start = Time(100s);
    description.faults.faults[0].duration = 100s;
    network.emplace(description);
    network->run_until(Time(110s));
    const std::size_t before = network->snapshot().served;
    network->run_until(Time(200s));
    EXPECT_GT(network->snapshot().served, before) << "each lift serves alone";
    network->run_until(Time(6min));
    EXPECT_EQ(broken(*network), "");
    EXPECT_TRUE(is_told(*network, 0x8130, Time(100s)));
    EXPECT_TRUE(is_decided(*network, InvariantKind::emergency_told));
    EXPECT_TRUE(is_decided(*network, InvariantKind::service_resumed));
    return *network;
  }
  std::optional<LiftNetwork> network;
};

TEST_P(LiftGroupFaultTest, WithoutTheirControllerLiftsServeAloneAndTell) {
  run({.kind = FaultKind::lost_node});
}
TEST_P(LiftGroupFaultTest, LiftsBehindACutCableServeAloneAndTell) {
  run({.kind = FaultKind::cable_cut, .node = 1});
}
TEST_P(LiftGroupFaultTest, WhileALiftBabblesInTheGroupEachServesAlone) {
  run({.kind = FaultKind::babbling_node, .node = 2});
}
INSTANTIATE_TEST_SUITE_P(HallAndDestinationCalls, LiftGroupFaultTest, testing::Bool());

}  // namespace
}  // namespace canvoy::lift::lift_group_fault_test
