// A device that a test puts on the bus of a simulated car by itself, with its own hardware, in the
// place of one that is not played there.
//
//     RealDevice alarm(network.world(), car::units_of<cia447::TaxiAlarmKind>, {.id = 8, ...}, 9);
//     alarm.join();
#pragma once

#include <optional>

#include "canvoy/sim/car/car_node.hpp"

namespace canvoy::car {

class RealDevice {
 public:
  /// `slot` is the first one that the world has left.
  RealDevice(World& world, std::span<const cia447::CarUnit* const> units,
             const CarNode::Place& place, SlotIndex slot)
      : world_(world), units_(units), place_(place), slot_(slot) {}

  template <class Thing>
  void offer(Callback<Thing()> thing) {
    site_.offer(thing);
  }
  template <class Unit>
  void watch(Callback<void(Unit&, Node&)> watcher) {
    site_.watch(watcher);
  }
  /// Again: one that was away comes back.
  void join() {
    if (!node_) node_.emplace(world_, 0, units_, place_, site_);
    node_->power(true);
  }
  void vanish() { node_->power(false); }
  /// Something was done to it from outside of the world.
  void touched() { world_.touched(slot_); }
  CarNode& node() { return *node_; }

 private:
  World& world_;
  std::span<const cia447::CarUnit* const> units_;
  CarNode::Place place_;
  SlotIndex slot_;
  Site site_;
  std::optional<CarNode> node_;
};

}  // namespace canvoy::car
