#include "canvoy/worlds/lift/shaft_nodes.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"

namespace canvoy::lift::shaft_nodes_test {
namespace {

/// A lift with a controller, a drive and two panels, and its node in a group.
struct ShaftNodesTest : testing::Test {
  /// Notes the node-ID of each sender; a node that starts sends at once (CiA 301, boot-up).
  struct Line {
    std::vector<NodeId>* order;
    NodeId id;
    static bool send(void* context, const Frame&) {
      const Line& line = *static_cast<Line*>(context);
      line.order->push_back(line.id);
      return true;
    }
  };
  Node& node(NodeId id) {
    lines.push_back({&started, id});
    return nodes.emplace_back(Port{&lines.back(), &Line::send, nullptr}, id).node;
  }
  SlotIndex add(NodeId id, DeviceKind kind) {
    const SlotIndex slot = world.add_slot(bus);
    Node& made = node(id);
    world.occupy(slot, made);
    sut.add(id, kind, slot, made);
    return slot;
  }
  void link() {
    group_slot = world.add_slot(group_bus);
    sut.link(node_id::lift_controller, group_slot, node(group_id));
  }

  static constexpr NodeId group_id = 3;
  World world;
  BusIndex bus = world.add_bus();
  BusIndex group_bus = world.add_bus();
  std::deque<Line> lines;
  std::deque<ServingNode> nodes;
  std::vector<NodeId> started;
  ShaftNodes sut{world, bus};
  SlotIndex panel = add(21, DeviceKind::landing_panel);
  SlotIndex controller = add(node_id::lift_controller, DeviceKind::lift_controller);
  SlotIndex car_panel = add(16, DeviceKind::car_panel);
  SlotIndex drive = add(node_id::drive, DeviceKind::drive);
  SlotIndex group_slot = 0;
};

TEST_F(ShaftNodesTest, StartWithPanelsLastAndThenOnTheBusOfTheGroup) {
  link();
  sut.start();
  EXPECT_EQ(started, (std::vector<NodeId>{1, 2, 21, 16, group_id}));
}

TEST_F(ShaftNodesTest, OfTheControllerHavePowerOnBothBusesOrOnNone) {
  link();
  sut.start();
  sut.power(node_id::lift_controller, false);
  EXPECT_FALSE(world.is_running(controller));
  EXPECT_FALSE(world.is_running(group_slot));
  EXPECT_TRUE(world.is_running(drive));
  sut.power(node_id::drive, false);
  sut.power(node_id::lift_controller, true);
  EXPECT_TRUE(world.is_running(controller));
  EXPECT_TRUE(world.is_running(group_slot));
  EXPECT_FALSE(world.is_running(drive)) << "it is lost for itself";
  sut.power(node_id::drive, false);
  EXPECT_TRUE(world.is_running(group_slot)) << "that of the group has the node-ID of the lift";
}

TEST_F(ShaftNodesTest, WithoutAGroupHaveOneBus) {
  sut.start();
  EXPECT_EQ(started, (std::vector<NodeId>{1, 2, 21, 16}));
  sut.power(node_id::lift_controller, false);
  EXPECT_FALSE(world.is_running(controller));
  EXPECT_TRUE(world.is_running(panel));
}

/// A real device in its place has its own power and cable.
TEST_F(ShaftNodesTest, ThatAreNotSimulatedHereAreLeftAlone) {
  sut.start();
  for (const bool on : {false, true}) {
    sut.power(node_id::position, on);
    sut.babble(node_id::position, on);
  }
  sut.cut_cable(node_id::position);
  for (const SlotIndex slot : {panel, controller, car_panel, drive}) {
    EXPECT_TRUE(world.is_running(slot));
  }
  EXPECT_EQ(started.size(), 4U) << "nobody has begun anew";
  EXPECT_FALSE(sut.slot(node_id::position).has_value());
  EXPECT_FALSE(sut.is_a(DeviceKind::position, node_id::position));
}

}  // namespace
}  // namespace canvoy::lift::shaft_nodes_test
