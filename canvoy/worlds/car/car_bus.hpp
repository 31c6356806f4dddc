// The bus of a simulated car and the devices on it, the gateway first: which are simulated here,
// which the gateway has stored before, which are at work, which sleep.
//
//     CarBus bus(world, {.names = device_names, .serial_numbers = 1000}, events);
//     bus.add(units_of<cia447::IvnGatewayKind>, environment);    // node-IDs from 1 on
//     bus.complete();
//     bus.node(2).power(true);
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/snapshot.hpp"
#include "canvoy/worlds/car/car_node.hpp"
#include "canvoy/worlds/car/real_identity.hpp"

namespace canvoy::car {

class CarBus {
 public:
  /// The bus and its devices.
  struct Settings {
    std::uint32_t bit_rate = 125'000;         ///< in bit/s
    std::uint64_t seed = 1;                   ///< of all chance on the bus
    std::span<const std::string_view> names;  ///< of the devices, from node-ID 1 on
    std::uint32_t serial_numbers = 0;         ///< serial number of a device: this plus its node-ID
    std::vector<NodeId> real{};               ///< devices that are not simulated here
    std::vector<RealIdentity> identities{};   ///< of the devices that are not simulated here
    Duration time_out{};                      ///< time after which a silent device is lost
    cia447::CarMasterSettings master{};       ///< without the places, which the bus adds
  };

  /// The world must outlive this object. `note` receives what is heard on the bus.
  CarBus(World& world, Settings settings, BusWatch::Note note);
  CarBus(const CarBus&) = delete;
  CarBus& operator=(const CarBus&) = delete;

  /// Adds the surroundings of devices; valid as long as this object.
  Environment& add_site() { return sites_.emplace_back(); }
  /// Adds the next device in one of these surroundings. It has no power yet.
  void add(std::span<const cia447::CarUnit* const> units, const Environment& environment);
  /// Call it when all devices are added. The gateway has them stored, so that they have the same
  /// node-IDs in each run. For real devices it keeps a place, by their identity or by their first
  /// virtual device.
  void complete();
  /// Starts to listen to the bus.
  void listen() { world_.bus(index_).observe(watch_.tap()); }

  /// The world of the bus.
  World& world() { return world_; }
  /// The bus in its world.
  BusIndex index() const { return index_; }
  /// The bus itself, for faults and observers.
  SimulatedBus& bus() { return world_.bus(index_); }
  /// Device with a node-ID from 1 on, which must exist.
  CarNode& node(NodeId id) { return *nodes_.at(id - std::size_t{1}); }
  /// Device 1.
  CarNode& gateway() { return *nodes_.front(); }
  /// All devices, in the order of their node-IDs.
  std::span<const std::unique_ptr<CarNode>> nodes() const { return nodes_; }
  /// Memory of the gateway that persists without power.
  cia447::CarMemory memory();
  /// Settings of the gateway, with the places for real devices.
  cia447::CarMasterSettings master_settings() const;

  /// True if the device is simulated here.
  bool is_played(NodeId id) const;
  /// True while the device runs.
  bool has_power(NodeId id) { return node(id).is_powered(); }
  /// Call it after the device was changed from outside of its bus.
  void touched(NodeId id) { world_.touched(node(id).slot()); }
  /// As far as can be seen of a device that is not simulated here.
  bool is_at_work(CarNode& node) const;
  /// True while a real device is not at work, and may still come.
  bool waits_for_real() const;
  /// True if this real device is not at work, and has had no time to come.
  bool may_come_yet(NodeId id) const;
  /// True if all devices that have power sleep.
  bool all_sleep() const;
  /// True also for a device that is about to sleep.
  bool any_sleeps() const;
  /// Master of the gateway; null where that is not simulated here.
  cia447::CarMaster* master();

  /// Load and state of the bus.
  BusSnapshot snapshot() const;
  /// States of the devices, in the order of nodes().
  std::vector<NodeSnapshot> node_snapshots() const;
  /// Names, in the order of nodes().
  std::vector<std::string_view> names() const;

 private:
  cia447::KnownDevices known() { return known_; }
  void keep(const cia447::KnownDevices& known) { known_ = known; }
  void keep_place(const CarNode& node);

  World& world_;
  Settings settings_;
  BusIndex index_;
  std::deque<Environment> sites_;
  std::vector<std::unique_ptr<CarNode>> nodes_;
  cia447::KnownDevices known_;  ///< memory of the gateway
  std::vector<cia447::CarPlace> places_;
  BusWatch watch_;
};

}  // namespace canvoy::car
