// The CANopen manager of the vehicle with a charger and its battery: it gives SDO connections to
// the nodes that request them (CiA 302-5; CiA 419, 6.1).
//
//     VehicleManager manager(world.port(slot), 1, {5, 10});
//     world.occupy(slot, manager.node());
#pragma once

#include <array>
#include <span>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302/sdo_manager.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::charger {

namespace detail {

/// Two connections at a time, of two COB-IDs each, and one channel for requests.
inline constexpr unsigned vehicle_cob_ids = 6;
inline constexpr auto vehicle_manager_device =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.product_code = 302}), cia301::heartbeat_producer(1000),
             cia301::sdo_servers(2), cia302::sdo_manager(vehicle_cob_ids, 4));
inline constexpr auto vehicle_manager_layout = lay_out_device<vehicle_manager_device>();

}  // namespace detail

class VehicleManager {
 public:
  /// `heartbeat_time_out`: a node that is silent for longer is lost, with its connections.
  VehicleManager(const Port& port, NodeId id, Duration heartbeat_time_out);
  VehicleManager(const VehicleManager&) = delete;
  VehicleManager& operator=(const VehicleManager&) = delete;

  /// The node of the manager.
  Node& node() { return device_.node(); }
  /// Connections at present.
  std::span<const SdoConnection> connections() const { return connections_; }
  /// Sets the function that is called whenever a connection may have been given, or begun to end.
  void on_change(Callback<void(Time)> changed) { manager_.on_change(changed); }

 private:
  static constexpr std::size_t routes = node_id_max + 2;

  void reset(ResetScope scope);

  DeviceNode<detail::vehicle_manager_layout, routes> device_;
  std::array<NmtMaster::RemoteNode, node_id_max> remote_nodes_;
  NmtMaster nodes_;
  std::array<SdoConnection, 4> connections_;
  SdoManager manager_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::charger
