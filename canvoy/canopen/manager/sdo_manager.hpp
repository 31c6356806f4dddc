// SDO manager: gives SDO connections to requesting devices, and takes them back (CiA 302-5).
//
// Objects 1F00h (request), 1F01h (release), 1F02h (the COB-IDs that it can assign), 1F03h to 1F06h
// (assigned connections, if the dictionary has them), and one SDO server (1201h and above) for each
// device that it serves.
//
//     std::array<SdoConnection, 16> connections;
//     SdoManager manager(node, connections, {});
//     heartbeats.on_change(
//         Callback<void(NodeId, RemoteState)>::to<&SdoManager::remote_changed>(manager));
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/manager/sdo_call_search.hpp"
#include "canvoy/canopen/manager/sdo_cob_ids.hpp"
#include "canvoy/canopen/manager/sdo_connections.hpp"
#include "canvoy/canopen/manager/sdo_connector.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// Performs one task at a time, on the default SDO channels of the nodes, of which it must be the
/// only user (CiA 302-5): finds the device that called on 6E0h, a call without further data (nodes
/// heard before first, then all others), opens a connection, closes one. It works in NMT states
/// pre-operational and operational.
///
/// A device that is lost or restarts loses its registration and its connections; if a server is
/// lost, its clients are notified by 1F10h. While a device has all default SDO channels, all else
/// waits.
///
/// A manager that is reset alone loses its record of assigned COB-IDs, while the servers still
/// listen to them: reset all nodes with it.
///
/// Details of CiA 302-5 that are unknown, and specific to this manager: the error codes; the
/// content of 1F03h to 1F06h; refusal of requests from devices that are not registered (0800
/// 0022h), and for a client channel that is connected to another server; channels are closed with
/// bits 31 and 30 set.
class SdoManager {
 public:
  /// Patience with the nodes.
  struct Settings {
    Duration time_out = 250ms;      ///< for one answer when a connection is opened or closed
    unsigned tries = 3;             ///< for each such request
    Duration scan_time_out = 50ms;  ///< for one answer of a node that may be absent
  };

  /// Makes the manager. `connections` limits the number of registrations and connections together;
  /// it must outlive the manager. The node needs one route for it, and one for its SDO client.
  SdoManager(Node& node, std::span<SdoConnection> connections, const Settings& settings);
  SdoManager(const SdoManager&) = delete;
  SdoManager& operator=(const SdoManager&) = delete;

  /// Notes that a node was heard, lost, or started: to be called for all nodes that may have
  /// connections.
  void remote_changed(NodeId node, RemoteState state);
  /// Sets the callback for any change of connections: assigned, or beginning to end.
  void on_change(Callback<void(Time)> changed) { changed_ = changed; }

  /// All places for connections; the unused ones included.
  std::span<const SdoConnection> connections() const { return connections_.all(); }
  /// True while a node is asked, or a connection is opened or closed.
  bool busy() const { return asked_ != 0 || connector_.busy(); }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void called(const Frame& frame, Time now);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void after_write(const Entry& entry, Source source);
  AbortCode check_request(const DynamicSdoRequest& request) const;
  AbortCode check_release(const DynamicSdoRequest& request) const;
  void request(const DynamicSdoRequest& request);
  void release(const DynamicSdoRequest& request);

  void work(Time now);
  void wake() { node_.timers().arm(timer_, node_.now()); }
  bool is_registered(NodeId device) const {
    return connections_.registration(device, node_.id()) != nullptr;
  }
  bool ask(NodeId node);
  void answered(SdoClient::Outcome outcome);
  void found(NodeId node, const DynamicSdoState& state);
  void ended(const SdoConnection* connection);
  void list(const SdoConnection& connection);

  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;

  Node& node_;
  Settings settings_;
  SdoClient client_;
  SdoConnections connections_;
  SdoCobIds cob_ids_;
  SdoConnector connector_;
  SdoCallSearch search_;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Callback<void(Time)> changed_;
  std::array<std::uint8_t, 4> buffer_{};
  NodeId asked_ = 0;  ///< node being read; 0: none
};

}  // namespace canvoy
