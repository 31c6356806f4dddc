// The cables of a bus, one in each car, and the physical devices on them: which are simulated
// here, which are at work.
//
//     BusNodes nodes(world, options, events);
//     nodes.add(next_stop_id, nodes.add_site());
//     nodes.complete();
//     nodes.node(next_stop_id).power(true);
#pragma once

#include <array>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/bus_line/bus_network_event.hpp"
#include "canvoy/worlds/bus_line/bus_network_options.hpp"
#include "canvoy/worlds/bus_line/bus_node.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

class BusNodes {
 public:
  /// All must outlive this object. What is heard on the cables goes to the events.
  BusNodes(World& world, const BusNetworkOptions& options, EventLog<NetworkEvent>& events);
  BusNodes(const BusNodes&) = delete;
  BusNodes& operator=(const BusNodes&) = delete;

  /// Adds the surroundings of a device; valid as long as this object.
  Environment& add_site() { return sites_.emplace_back(); }
  /// Adds a device of device_places, without power.
  void add(DeviceKey key, const Environment& environment);
  /// Adds a device of the design.
  void add(const AddedDevice& device, const Environment& environment);
  /// Call it when all devices are added: it puts them in the order of their node-IDs.
  void complete();
  /// Starts to listen to the cable of a car.
  void listen(unsigned car) { cable(car).observe(watches_.at(car - 1).tap()); }

  /// The world of all cables.
  World& world() { return world_; }
  /// Cars with a cable: two where the bus has one car, which has nothing on the second.
  unsigned cars() const { return cars_made(design().cars); }
  /// Cable of a car, from 1 to cars(); throws std::out_of_range for another.
  SimulatedBus& cable(unsigned car) { return world_.bus(indices_.at(car - 1)); }
  /// Index of the cable of a device; for 0, that of the first.
  BusIndex index_of(DeviceKey key) const { return indices_.at(car_of(key) - 1); }
  /// Car of a device; 1 for one that is not on the bus.
  unsigned car_of(DeviceKey key) const;
  /// The device that starts this one; itself, where it starts the others.
  DeviceKey master_of(DeviceKey key) const { return master_in(car_of(key)); }
  /// Node-ID of a device.
  NodeId id(DeviceKey key) const { return id_of(design(), key); }
  /// Devices and vehicle by design.
  const BusDesign& design() const { return options_.design; }
  /// A device by its key, which is one of this bus.
  BusNode& node(DeviceKey key) { return *by_key_.at(key); }
  /// All devices of the bus, in the order in which they were added.
  std::span<const std::unique_ptr<BusNode>> all() const { return nodes_; }
  /// False for a device of a car that the bus does not have: it is never on.
  bool is_there(DeviceKey key) const;

  /// True if it is simulated here.
  bool is_played(DeviceKey key) const;
  /// As far as can be seen of a device that is not simulated here.
  bool is_at_work(DeviceKey key);
  /// True if the device may still come: or the device that starts it is not simulated here, and may
  /// start it at any time.
  bool is_awaited(DeviceKey key) const;
  /// Time after which the device is lost without its heartbeat: short for a simulated device, which
  /// sends it every 500 ms; longer for a real one, which may send it every second.
  Duration heartbeat_time_out(DeviceKey key) const;

  /// Load and state of the cables.
  std::vector<BusSnapshot> cable_snapshots();
  /// States of the devices, in the order of all().
  std::vector<NodeSnapshot> node_snapshots();
  /// Names, in the order of all().
  std::vector<std::string_view> names() const;

 private:
  void add(const BusNode::Place& place, std::span<const cia407::BusUnit* const> units,
           const Environment& environment);

  World& world_;
  const BusNetworkOptions& options_;
  std::vector<BusIndex> indices_;  ///< of each car
  std::deque<Environment> sites_;
  std::vector<std::unique_ptr<BusNode>> nodes_;
  std::vector<std::unique_ptr<BusNode>> absent_;
  std::array<BusNode*, std::numeric_limits<DeviceKey>::max() + 1> by_key_{};
  std::deque<BusWatch> watches_;  ///< of each cable
};

}  // namespace canvoy::bus_line
