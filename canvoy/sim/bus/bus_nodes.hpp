// The two cables of a bus, one in each car, and the physical devices on them: who is played here,
// who is at work.
//
//     BusNodes nodes(world, options, events);
//     nodes.add(next_stop_id, nodes.add_site());
//     nodes.complete();
//     nodes.node(next_stop_id).power(true);
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/sim/bus/bus_network_event.hpp"
#include "canvoy/sim/bus/bus_network_options.hpp"
#include "canvoy/sim/bus/bus_node.hpp"
#include "canvoy/sim/bus/bus_places.hpp"
#include "canvoy/sim/bus_watch.hpp"
#include "canvoy/sim/event_log.hpp"
#include "canvoy/sim/snapshot.hpp"

namespace canvoy::bus {

class BusNodes {
 public:
  /// All must outlive this. What is heard on the cables goes to the events.
  BusNodes(World& world, const BusNetworkOptions& options, EventLog<NetworkEvent>& events);
  BusNodes(const BusNodes&) = delete;
  BusNodes& operator=(const BusNodes&) = delete;

  /// A place for a device; it lives as long as that.
  Site& add_site() { return sites_.emplace_back(); }
  /// One of device_places. It has no power yet.
  void add(NodeId id, const Site& site);
  /// All are there: from now on they are in the order of their node-IDs.
  void complete();
  /// From now on frames on the cable of a car are heard.
  void listen(unsigned car) { cable(car).observe(watches_.at(car - 1).tap()); }

  World& world() { return world_; }
  SimulatedBus& cable(unsigned car) { return world_.bus(indices_.at(car - 1)); }
  /// The one at which a device is; 0 is at the first.
  BusIndex index_of(NodeId id) const { return indices_.at(car_of(id) - 1); }
  BusNode& node(NodeId id) { return *by_id_.at(id); }
  std::span<const std::unique_ptr<BusNode>> all() const { return nodes_; }

  bool is_played(NodeId id) const;
  /// As far as can be known of one that is not played.
  bool is_at_work(NodeId id);
  /// It may come yet; or who starts it is not played, and does as it likes.
  bool is_awaited(NodeId id) const;
  /// Without its heartbeat: of who has one of 500 ms here; a real one may have the usual second.
  Duration heartbeat_time_out(NodeId id) const;

  std::array<BusSnapshot, 2> cable_snapshots();
  std::vector<NodeSnapshot> node_snapshots();
  std::vector<std::string_view> names() const;

 private:
  World& world_;
  const BusNetworkOptions& options_;
  std::array<BusIndex, 2> indices_;  ///< of each car
  std::deque<Site> sites_;
  std::vector<std::unique_ptr<BusNode>> nodes_;
  std::array<BusNode*, node_id_max + 1> by_id_{};
  std::array<BusWatch, 2> watches_;
};

}  // namespace canvoy::bus
