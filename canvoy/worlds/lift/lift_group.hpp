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
  LiftGroup(World& world, BusIndex bus, NodeId id, const LiftNetworkDescription& description);
  LiftGroup(const LiftGroup&) = delete;
  LiftGroup& operator=(const LiftGroup&) = delete;
  ~LiftGroup();

  void start();
  SlotIndex slot() const { return slot_; }
  BusIndex bus() const { return bus_; }
  Node& node();

 private:
  struct Device;

  World* world_;
  BusIndex bus_;
  SlotIndex slot_;
  std::unique_ptr<Device> device_;
};

}  // namespace canvoy::lift
