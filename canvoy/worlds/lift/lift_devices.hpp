// All devices of a building as CANopen nodes on their buses, with cars, doors and scales behind
// them: the shafts of its lifts, the group controller, and the values that the description writes
// into nodes. It has no people, and no plan of faults.
//
//     LiftDevices devices(world, description, {.shaft = {.changed = ...}, .heard = ...});
//     devices.start();
//     devices.shaft(2).facts(world.now());
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/lift/lift_shaft.hpp"

namespace canvoy::lift {

/// The group controller of a building on the bus of the group.
///
///     LiftGroup group(world, bus, 17, description);
///     group.start();
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

/// Functions that receive reports. None may be empty; none is called before start().
struct LiftDevicesHooks {
  ShaftHooks shaft{};  ///< reports of every shaft
  /// Reports of the nodes of a bus.
  std::function<void(Time, const BusEvent&)> heard{};
};

class LiftDevices {
 public:
  /// `world` and `description` must outlive this object.
  LiftDevices(World& world, const LiftNetworkDescription& description, LiftDevicesHooks hooks);
  LiftDevices(const LiftDevices&) = delete;
  LiftDevices& operator=(const LiftDevices&) = delete;

  /// Switches on all nodes.
  void start();

  /// Number of lifts.
  LiftNumber count() const { return static_cast<LiftNumber>(shafts_.size()); }
  /// Shaft of a lift, from 1.
  LiftShaft& shaft(LiftNumber lift) { return *shafts_[lift - std::size_t{1}]; }
  /// Shaft of a lift, from 1.
  const LiftShaft& shaft(LiftNumber lift) const { return *shafts_[lift - std::size_t{1}]; }
  /// A bus by its place in the description; throws std::out_of_range beyond it.
  SimulatedBus& bus(std::size_t bus) { return world_->bus(buses_.at(bus)); }

  /// Begins or ends a fault in one shaft, or on the bus of the group (lift 0).
  void set_fault(const ScheduledFault& fault, bool present);
  /// Place of a fault: the node in the plan, or the first one that suits its kind.
  FaultPlace place_of(const ScheduledFault& fault) const;
  /// True if the node is behind the cut. Nodes stand on the cable of a lift in the order of their
  /// description; the real bus is at its end.
  bool is_behind(NodeId node, const ScheduledFault& cut) const;
  /// Lift of a bus; 0: the group.
  LiftNumber lift_of(std::size_t bus) const;

  /// The first value that a node refused at its last boot-up.
  std::optional<RefusedValue> refused() const;
  /// Load and state of each bus, in the order of the description.
  std::vector<BusSnapshot> bus_snapshots() const;
  /// Snapshots of the nodes that are simulated here, in the order of the description.
  std::vector<NodeSnapshot> node_snapshots();

 private:
  struct Configuration {
    const NodeDescription* node = nullptr;
    std::unique_ptr<NodeConfiguration> values{};
  };

  void add_buses();
  void add_shafts(const ShaftHooks& hooks);
  void add_group();
  void add_configurations();
  /// Null where the node is not simulated here.
  Node* node_of(const NodeDescription& node);
  std::optional<SlotIndex> group_slot(NodeId node) const;
  void set_group_fault(const ScheduledFault& fault, bool present);

  World* world_;
  const LiftNetworkDescription* description_;
  std::function<void(Time, const BusEvent&)> heard_;
  std::vector<BusIndex> buses_;
  std::vector<std::unique_ptr<BusWatch>> watches_;
  std::vector<std::unique_ptr<LiftShaft>> shafts_;
  std::unique_ptr<LiftGroup> group_;  ///< null where it is not simulated here
  std::vector<Configuration> configurations_;
};

}  // namespace canvoy::lift
