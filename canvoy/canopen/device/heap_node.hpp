// A node with the services of CiA 301 that its dictionary needs, in memory from the heap: for
// dictionaries known at run time (data sheets, devices composed of units). DeviceNode is for
// dictionaries known at compile time.
//
//     HeapNode device(tables, port, 5);
//     device.node().start(now);
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"

namespace canvoy {

class HeapNode {
 public:
  /// Makes the node. `tables` refers to rows that must outlive this object. `port` is copied; its
  /// context must outlive this object. `further_routes` is the number of CAN-IDs that the
  /// application's services need.
  HeapNode(const DictionaryTables& tables, const Port& port, NodeId node_id,
           std::size_t further_routes = 0);
  HeapNode(const HeapNode&) = delete;
  HeapNode& operator=(const HeapNode&) = delete;

  /// The node itself: frames and points in time are handed to it.
  Node& node() { return *node_; }
  /// Sends errors that the application raises; valid as long as this object.
  EmergencyProducer& emergency_producer() { return *emergency_producer_; }
  /// The tables that were handed in.
  const DictionaryTables& tables() const { return tables_; }
  /// First entry that CiA 301 requires of a device with these objects and that it lacks; an entry
  /// without a rule if none. A DeviceNode does not compile in that case; for a HeapNode the caller
  /// decides, since a simulated foreign device may lack objects.
  MissingEntry missing() const { return find_missing(tables_); }

 private:
  void keep_initial_values();
  bool has(std::uint16_t index) const;
  void add_sdo_servers();
  detail::PdoNumbers rpdo_numbers() const;
  detail::PdoNumbers tpdo_numbers() const;
  void add_pdos();
  void add_mpdos();

  DictionaryTables tables_;
  std::vector<std::uint8_t> initial_bytes_;
  std::vector<InitialValues::WithNodeId> with_node_id_;
  std::vector<std::uint8_t> values_;
  std::vector<ObjectState> states_;
  std::vector<Router::Route> routes_;
  std::vector<Frame> backlog_;
  std::vector<Error> errors_;
  std::vector<Emergency> emergencies_;
  std::vector<std::vector<std::uint8_t>> sdo_buffers_;
  std::vector<HeartbeatConsumer::Slot> heartbeat_slots_;
  std::vector<EmergencyConsumer::Slot> emergency_slots_;
  std::vector<Rpdo> rpdo_memory_;
  std::vector<Tpdo> tpdo_memory_;
  std::vector<MappedValue> rpdo_values_;
  std::vector<MappedValue> tpdo_values_;
  std::vector<ScannedObject> scanned_objects_;
  std::vector<MpdoProducer::Message> mpdo_queue_;
  std::vector<CollisionWatch::Slot> own_ids_;

  std::unique_ptr<Node> node_;
  std::deque<SdoServer> sdo_servers_;
  std::deque<SdoBlockServer> sdo_block_servers_;
  std::unique_ptr<EmergencyProducer> emergency_producer_;
  std::optional<ErrorBehaviour> error_behaviour_;
  std::optional<HeartbeatProducer> heartbeat_producer_;
  std::optional<HeartbeatConsumer> heartbeat_consumer_;
  std::optional<EmergencyConsumer> emergency_consumer_;
  std::optional<NodeGuardingSlave> node_guarding_;
  std::optional<TimeStamp> time_stamp_;
  std::unique_ptr<Sync> sync_;
  std::optional<VerifyConfiguration> verify_configuration_;
  std::optional<HighResolutionTime> high_resolution_time_;
  std::optional<Rpdos> rpdos_;
  std::optional<Tpdos> tpdos_;
  std::optional<MpdoConsumer> mpdo_consumer_;
  std::optional<MpdoProducer> mpdo_producer_;
  std::optional<CollisionWatch> collision_watch_;
};

}  // namespace canvoy
