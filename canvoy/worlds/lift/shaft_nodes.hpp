// The nodes of one lift that are simulated here: their slots on its bus, their power and their
// cable.
//
//     ShaftNodes nodes(world, bus);
//     nodes.add(description, slot, device.node());
//     nodes.start();
//     nodes.power(2, false);
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/linked_node.hpp"

namespace canvoy::lift {

class ShaftNodes {
 public:
  /// `world` must outlive this object.
  ShaftNodes(World& world, BusIndex bus) : world_(&world), bus_(bus) {}
  ShaftNodes(const ShaftNodes&) = delete;
  ShaftNodes& operator=(const ShaftNodes&) = delete;

  /// `node` already occupies its slot, and must outlive the last run of the world.
  void add(NodeId id, DeviceKind kind, SlotIndex slot, Node& node);
  /// Adds the second node of the controller, on the bus of a group: one device with two CAN
  /// interfaces.
  void link(NodeId controller, SlotIndex group_slot, Node& member);

  /// Switches on all nodes: panels last, then the second node of the controller.
  void start();
  /// Switches power; does nothing where the node is not simulated here. A controller has power at
  /// both of its nodes, or at none.
  void power(NodeId id, bool is_on);
  /// Cuts the cable behind that node. There is one cut at a time.
  void cut_cable(NodeId id);
  /// Connects the cable again, where it is cut.
  void mend_cable() { world_->bus(bus_).mend_cable(); }
  /// Makes the node send without end a virtual input that does not exist, like a defective panel.
  void babble(NodeId id, bool babbles);

  /// Slot of a node; empty where it is not simulated here.
  std::optional<SlotIndex> slot(NodeId id) const;
  /// Null where the node is not simulated here.
  Node* node(NodeId id) const;
  /// Slot of the controller on the bus of the group; empty without a group.
  std::optional<SlotIndex> group_slot() const { return group_slot_; }
  /// True if the node is simulated here, and of this kind.
  bool is_a(DeviceKind kind, NodeId id) const;

 private:
  struct Entry {
    NodeId id = 0;
    DeviceKind kind = DeviceKind::lift_controller;
    SlotIndex slot = 0;
    Node* node = nullptr;
  };
  const Entry* find(NodeId id) const;

  World* world_;
  BusIndex bus_;
  std::vector<Entry> nodes_;
  std::optional<SlotIndex> group_slot_{};
  std::unique_ptr<LinkedNode> on_own_bus_{};
  std::unique_ptr<LinkedNode> on_group_bus_{};
};

}  // namespace canvoy::lift
