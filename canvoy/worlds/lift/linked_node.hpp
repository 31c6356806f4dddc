// One of the two nodes of a device with two CAN interfaces: what happens to it may give the other
// node something to do, so that the deadline of that node is read again.
//
//     LinkedNode linked(world, lift_node, group_slot);
//     world.occupy(lift_slot, linked);
#pragma once

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

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

}  // namespace canvoy::lift
