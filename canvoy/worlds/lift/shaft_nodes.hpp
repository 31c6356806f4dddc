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

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"

namespace canvoy::lift {

/// One of the two nodes of a device with two CAN interfaces: what happens to it may give the other
/// node something to do, so that the deadline of that node is read again.
///
///     LinkedNode linked(world, lift_node, group_slot);
///     world.occupy(lift_slot, linked);
class LinkedNode {
 public:
  /// `other` is the slot of the other node. World and node must outlive this object.
  LinkedNode(World& world, Node& node, SlotIndex other)
      : world_(&world), node_(&node), other_(other) {}

  /// As World requires it of a node: each of these calls the node, then has the deadline of the
  /// other one read again.
  void start(Time now) {
    node_->start(now);
    touch();
  }
  /// See start().
  void receive(const Frame& frame, Time now) {
    node_->receive(frame, now);
    touch();
  }
  /// See start().
  void advance(Time now) {
    node_->advance(now);
    touch();
  }
  /// That of the node itself.
  Time deadline() const { return node_->deadline(); }
  /// See start().
  void bus_state(BusState state, Time now) {
    node_->bus_state(state, now);
    touch();
  }
  /// See start().
  void tx_ready(Time now) {
    node_->tx_ready(now);
    touch();
  }
  /// The node takes it; nothing is due by it.
  void overrun(Time now) { node_->overrun(now); }
  /// See Node::mapping_reads().
  std::uint32_t mapping_reads() const { return node_->mapping_reads(); }

 private:
  void touch() {
    if (world_->is_running(other_)) world_->touched(other_);
  }

  World* world_;
  Node* node_;
  SlotIndex other_;
};

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
