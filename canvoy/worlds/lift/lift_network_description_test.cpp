#include "canvoy/worlds/lift/lift_network_description.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace canvoy::lift::lift_network_description_test {
namespace {

std::size_t count(const LiftNetworkDescription& network, DeviceKind kind) {
  return static_cast<std::size_t>(
      std::count_if(network.nodes.begin(), network.nodes.end(),
                    [&](const NodeDescription& node) { return node.kind == kind; }));
}

TEST(LiftNetworkDescriptionTest, OneLiftHasOneBusWithTheRecommendedNodeIds) {
  const LiftNetworkDescription network = standard_lift_network({.floors = 6});
  EXPECT_EQ(check(network), "");
  ASSERT_EQ(network.buses.size(), 1U);
  EXPECT_EQ(network.buses[0].bit_rate, 250'000U);
  std::vector<unsigned> ids;
  for (const NodeDescription& node : network.nodes) ids.push_back(node.id);
  EXPECT_EQ(ids, (std::vector<unsigned>{1, 2, 4, 6, 9, 13, 16, 21, 22, 23, 24, 25, 26}));
}

TEST(LiftNetworkDescriptionTest, EightLiftsOfAHundredFloorsHaveNineBusesAndSome850Nodes) {
  const LiftNetworkDescription network = standard_lift_network({.lifts = 8, .floors = 100});
  EXPECT_EQ(check(network), "");
  EXPECT_EQ(network.buses.size(), 9U);
  EXPECT_EQ(count(network, DeviceKind::landing_panel), 800U);
  EXPECT_EQ(network.nodes.size(), 8U * 107 + 1);
}

TEST(LiftNetworkDescriptionTest, WhereThereAreMoreFloorsThanNodeIdsAPanelHasSeveral) {
  const LiftNetworkDescription network = standard_lift_network({.floors = 254});
  EXPECT_EQ(check(network), "");
  EXPECT_EQ(count(network, DeviceKind::landing_panel), 85U);
  EXPECT_EQ(network.nodes.back().floors, (std::vector<FloorNumber>{253, 254}));
}

TEST(LiftNetworkDescriptionTest, EachDoorHasItsUnit) {
  StandardLifts options;
  options.lift.doors = 0b1011;
  const LiftNetworkDescription network = standard_lift_network(options);
  EXPECT_EQ(check(network), "");
  EXPECT_EQ(count(network, DeviceKind::door), 3U);
  EXPECT_EQ(count(network, DeviceKind::light_barrier), 1U);
}

TEST(LiftNetworkDescriptionTest, KindsHaveNamesThatAreReadBack) {
  for (unsigned i = 0; i <= static_cast<unsigned>(DeviceKind::landing_panel); ++i) {
    const auto kind = static_cast<DeviceKind>(i);
    EXPECT_EQ(device_kind_of(device_kind_name(kind)), kind);
  }
  EXPECT_EQ(device_kind_of("toaster"), std::nullopt);
  EXPECT_EQ(device_kind_name(static_cast<DeviceKind>(77)), "");
}

struct WrongDescriptionTest : testing::Test {
  LiftNetworkDescription network = standard_lift_network({.floors = 3});
};

TEST_F(WrongDescriptionTest, TwoNodesWithOneNodeId) {
  network.nodes[1].id = 1;
  EXPECT_EQ(check(network), "lift-drive with node-ID 1 is not the only one");
}
TEST_F(WrongDescriptionTest, ANodeOnABusThatIsNotThere) {
  network.nodes[1].bus = 1;
  EXPECT_EQ(check(network), "lift-drive with node-ID 2 is on a bus that is not there");
}
TEST_F(WrongDescriptionTest, ANodeOfALiftThatIsNotThere) {
  network.nodes[1].lift = 2;
  EXPECT_EQ(check(network), "lift-drive with node-ID 2 belongs to a lift that is not there");
}
TEST_F(WrongDescriptionTest, ANodeIdThatIsNone) {
  network.nodes[1].id = 128;
  EXPECT_EQ(check(network), "lift-drive with node-ID 128: node-IDs are 1 to 127");
}
TEST_F(WrongDescriptionTest, APanelAtAFloorThatIsNotThere) {
  network.nodes.back().floors = {4};
  EXPECT_EQ(check(network),
            "lift-landing-panel with node-ID 23 hangs at a floor that is not there");
}
TEST_F(WrongDescriptionTest, APanelAtNoFloor) {
  network.nodes.back().floors.clear();
  EXPECT_EQ(check(network), "lift-landing-panel with node-ID 23 needs a floor");
}
TEST_F(WrongDescriptionTest, ADriveAtAFloor) {
  network.nodes[1].floors = {1};
  EXPECT_EQ(check(network), "lift-drive with node-ID 2 hangs at no floor");
}
TEST_F(WrongDescriptionTest, NoSuchDoor) {
  network.nodes[3].doors = 0;
  EXPECT_EQ(check(network), "lift-door with node-ID 6 has no such door");
}
TEST_F(WrongDescriptionTest, FloorsThatAreNotAboveEachOther) {
  network.building.floors[1].height_m = 0;
  EXPECT_EQ(check(network), "a floor is not higher than the one below it");
}
TEST_F(WrongDescriptionTest, NoLift) {
  network.building.lifts.clear();
  EXPECT_EQ(check(network), "a building has 1 to 8 lifts");
}
TEST_F(WrongDescriptionTest, OneFloorOnly) {
  network.building.floors.resize(1);
  EXPECT_EQ(check(network), "a building has 2 to 254 floors");
}
TEST_F(WrongDescriptionTest, AMainFloorThatIsNotThere) {
  network.building.main_floor = 4;
  EXPECT_EQ(check(network), "the main floor is not there");
}
TEST_F(WrongDescriptionTest, AFireOrParkingFloorThatIsNotThere) {
  network.service.parking_floor = 4;
  EXPECT_EQ(check(network), "the parking floor is not there");
  network.service.fire_floor = 4;
  EXPECT_EQ(check(network), "the fire floor is not there");
}

struct WrongFaultTest : testing::Test {
  static std::string check_of(const ScheduledFault& fault, LiftNumber lifts = 1) {
    LiftNetworkDescription network = standard_lift_network({.lifts = lifts, .floors = 3});
    network.faults.faults = {fault};
    return check(network);
  }
};

TEST_F(WrongFaultTest, OfALiftThatIsNotThere) {
  EXPECT_EQ(check_of({.part = 2}), "fault lost-node: there is no lift 2");
}
TEST_F(WrongFaultTest, OfANodeThatIsNotThere) {
  EXPECT_EQ(check_of({.node = 21}), "");
  EXPECT_EQ(check_of({.node = 99}), "fault lost-node: lift 1 has no node 99");
}
TEST_F(WrongFaultTest, AtAFloorThatIsNotThere) {
  EXPECT_EQ(check_of({.kind = FaultKind::stuck_button, .spot = 3}), "");
  EXPECT_EQ(check_of({.kind = FaultKind::stuck_button, .spot = 4}),
            "fault stuck-button: the floor is not there");
}
TEST_F(WrongFaultTest, WithANodeOrAFloorThatSayNothing) {
  EXPECT_EQ(check_of({.kind = FaultKind::dead_encoder, .node = 4}),
            "fault dead-encoder: it has no node");
  EXPECT_EQ(check_of({.kind = FaultKind::lost_node, .spot = 2}),
            "fault lost-node: it has no floor");
}
TEST_F(WrongFaultTest, OfAGroupThatIsNotThere) {
  EXPECT_EQ(check_of({.part = 0}), "fault lost-node: there is no group");
  EXPECT_EQ(check_of({.kind = FaultKind::fire_alarm, .part = 0}), "");
}
TEST_F(WrongFaultTest, OfAGroupThatCannotHaveIt) {
  EXPECT_EQ(check_of({.kind = FaultKind::dead_encoder, .part = 0}, 2),
            "fault dead-encoder: it is no fault of a group");
  EXPECT_EQ(check_of({.kind = FaultKind::lost_node, .part = 0, .node = 17}, 2), "");
  EXPECT_EQ(check_of({.kind = FaultKind::lost_node, .part = 0, .node = 2}, 2),
            "fault lost-node: of a group it is its controller");
  EXPECT_EQ(check_of({.kind = FaultKind::cable_cut, .part = 0, .node = 2}, 2), "");
  EXPECT_EQ(check_of({.kind = FaultKind::cable_cut, .part = 0, .node = 3}, 2),
            "fault cable-cut: there is no node 3 on the bus of the group");
}

}  // namespace
}  // namespace canvoy::lift::lift_network_description_test
