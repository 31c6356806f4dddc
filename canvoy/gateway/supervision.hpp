// Monitors the nodes of a network by heartbeat and node guarding (CiA 309-1, enable and disable
// guarding, start and disable heartbeat consumer).
//
//     Supervision supervision(device, [](NodeId node, ErrorCode error) { ... });
//     supervision.watch_heartbeat(5, 100ms);
#pragma once

#include <array>
#include <bitset>
#include <functional>

#include "canvoy/canopen/nmt/node_guarding_master.hpp"
#include "canvoy/gateway/answer.hpp"
#include "canvoy/gateway/gateway_device.hpp"

namespace canvoy::gateway {

/// Monitors nodes. Reports heartbeat_started and heartbeat_lost, guarding_lost and wrong_nmt_state.
/// Answers unknown_node for a number that is not a node-ID.
class Supervision {
 public:
  /// Called with a node and what has happened to it.
  using Report = std::function<void(NodeId, ErrorCode)>;

  /// Makes the service; `device` must outlive it.
  Supervision(GatewayDevice& device, Report report);
  Supervision(const Supervision&) = delete;
  Supervision& operator=(const Supervision&) = delete;

  /// Starts monitoring of a heartbeat; a time of zero ends it.
  Answer watch_heartbeat(std::uint32_t node, Duration time);
  /// Starts node guarding, which needs a node-ID of the gateway; a guard time or life time factor
  /// of zero ends it.
  Answer guard(std::uint32_t node, Duration guard_time, std::uint8_t life_time_factor);
  /// Notes that a node, or all nodes (0), received an NMT command.
  void commanded(NodeId node, NmtCommand command);

 private:
  AbortCode set_time(std::uint32_t node, Duration time);
  void heartbeat_changed(NodeId node, RemoteState state);
  void guarding_event(NodeId node, NodeGuardingEvent event, bool occurs);

  GatewayDevice& device_;
  Report report_;
  std::bitset<node_id_max + 1> heard_;  ///< nodes with a heartbeat
  std::array<NodeGuardingMaster::Slot, node_id_max> slots_;
  NodeGuardingMaster guarding_;
};

}  // namespace canvoy::gateway
