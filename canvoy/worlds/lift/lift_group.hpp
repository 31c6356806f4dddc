// The group controller of a building on the bus of the group.
//
//     LiftGroup group(world, bus, 17, description);
//     group.start();
#pragma once

#include <memory>

#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"

namespace canvoy::lift {

class LiftGroup {
 public:
  /// Makes the node by the group of `description`, without power.
  LiftGroup(World& world, BusIndex bus, NodeId id, const LiftNetworkDescription& description);
  LiftGroup(const LiftGroup&) = delete;
  LiftGroup& operator=(const LiftGroup&) = delete;
  ~LiftGroup();

  /// Gives power.
  void start();
  /// Its slot on the bus of the group.
  SlotIndex slot() const { return slot_; }
  /// The bus of the group.
  BusIndex bus() const { return bus_; }
  /// The node; valid as long as the group.
  Node& node();

 private:
  struct Device;

  World* world_;
  BusIndex bus_;
  SlotIndex slot_;
  std::unique_ptr<Device> device_;
};

}  // namespace canvoy::lift
