// The bus of a simulated car and the devices on it, the gateway first: who is played here, whom the
// gateway knows from before, who is at work, who sleeps.
//
//     CarBus bus(world, {.names = device_names, .serial_numbers = 1000}, events);
//     bus.add(units_of<cia447::IvnGatewayKind>, site);    // node-IDs from 1 on
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
#include "canvoy/sim/car/car_node.hpp"
#include "canvoy/sim/snapshot.hpp"

namespace canvoy::car {

class CarBus {
 public:
  struct Settings {
    std::uint32_t bit_rate = 125'000;
    std::uint64_t seed = 1;
    std::span<const std::string_view> names;  ///< of the devices, from node-ID 1 on
    std::uint32_t serial_numbers = 0;         ///< a device has this one and its node-ID
    std::vector<NodeId> real{};               ///< who is not played here
    Duration time_out{};                      ///< who is not heard for so long is lost
  };

  /// The world must outlive this. `note` is told what is heard on the bus.
  CarBus(World& world, Settings settings, BusWatch::Note note);
  CarBus(const CarBus&) = delete;
  CarBus& operator=(const CarBus&) = delete;

  /// A place for devices; it lives as long as they.
  Site& add_site() { return sites_.emplace_back(); }
  /// The next device, at one of those places. It has no power yet.
  void add(std::span<const cia447::CarUnit* const> units, const Site& site);
  /// All are there. The gateway knows them from before: so they have the same node-IDs in each run.
  void complete();
  /// From now on frames are heard.
  void listen() { world_.bus(index_).observe(watch_.tap()); }

  World& world() { return world_; }
  BusIndex index() const { return index_; }
  SimulatedBus& bus() { return world_.bus(index_); }
  CarNode& node(NodeId id) { return *nodes_.at(id - std::size_t{1}); }
  CarNode& gateway() { return *nodes_.front(); }
  std::span<const std::unique_ptr<CarNode>> nodes() const { return nodes_; }
  /// What the gateway keeps without power.
  cia447::CarMemory memory();

  bool is_played(NodeId id) const;
  bool has_power(NodeId id) { return node(id).is_powered(); }
  /// Something was done to the device from outside of its bus.
  void touched(NodeId id) { world_.touched(node(id).slot()); }
  /// As far as can be known of one that is not played.
  bool is_at_work(CarNode& node) const;
  /// Not all do their work, and may begin it yet, since somebody is real.
  bool waits_for_real() const;
  /// Somebody is real, and this one, which is not at work, has had no time to come.
  bool may_come_yet(NodeId id) const;
  /// Of those that have power.
  bool all_sleep() const;
  /// Also one that is about to.
  bool any_sleeps() const;
  /// The gateway's, where it is played; else null.
  cia447::CarMaster* master();

  BusSnapshot snapshot() const;
  std::vector<NodeSnapshot> node_snapshots() const;
  std::vector<std::string_view> names() const;

 private:
  cia447::KnownDevices known() { return known_; }
  void keep(const cia447::KnownDevices& known) { known_ = known; }

  World& world_;
  Settings settings_;
  BusIndex index_;
  std::deque<Site> sites_;
  std::vector<std::unique_ptr<CarNode>> nodes_;
  cia447::KnownDevices known_;  ///< kept by the gateway
  BusWatch watch_;
};

}  // namespace canvoy::car
