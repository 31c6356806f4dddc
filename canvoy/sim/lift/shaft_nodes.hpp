// The nodes of one lift that are simulated here: who stands where on its bus, with power and cable.
//
//     ShaftNodes nodes(world, bus);
//     nodes.add(description, slot, device.node());
//     nodes.start();
//     nodes.power(2, false);
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/linked_node.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

class ShaftNodes {
 public:
  /// `world` must outlive this.
  ShaftNodes(World& world, BusIndex bus) : world_(&world), bus_(bus) {}
  ShaftNodes(const ShaftNodes&) = delete;
  ShaftNodes& operator=(const ShaftNodes&) = delete;

  /// `node` is at its slot already, and outlives the last run of the world.
  void add(NodeId id, DeviceKind kind, SlotIndex slot, Node& node);
  /// The controller has a second node, on the bus of a group: one device with two CAN interfaces.
  void link(NodeId controller, SlotIndex group_slot, Node& member);

  /// Gives all power: panels last, then the second node of the controller.
  void start();
  /// Nothing where it is not simulated here. A controller has both of its nodes, or none.
  void power(NodeId id, bool is_on);
  /// Behind that node. There is one cut at a time.
  void cut_cable(NodeId id);
  void mend_cable() { world_->bus(bus_).mend_cable(); }
  /// As a panel that sends without end a virtual input that is none.
  void babble(NodeId id, bool babbles);

  std::optional<SlotIndex> slot(NodeId id) const;
  /// Null where it is not simulated here.
  Node* node(NodeId id) const;
  std::optional<SlotIndex> group_slot() const { return group_slot_; }
  /// It is simulated here.
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
