// Watches over the nodes of a network, by their heartbeats and by node guarding (CiA 309-1, enable
// and disable guarding, start and disable heartbeat consumer).
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

/// It reports heartbeat_started and heartbeat_lost, guarding_lost and wrong_nmt_state. What is not
/// a node-ID is answered with unknown_node.
class Supervision {
 public:
  using Report = std::function<void(NodeId, ErrorCode)>;

  Supervision(GatewayDevice& device, Report report);
  Supervision(const Supervision&) = delete;
  Supervision& operator=(const Supervision&) = delete;

  /// A time of zero ends it.
  Answer watch_heartbeat(std::uint32_t node, Duration time);
  /// A guard time or life time factor of zero ends it. Guarding needs a node-ID of the gateway.
  Answer guard(std::uint32_t node, Duration guard_time, std::uint8_t life_time_factor);
  /// A node, or with 0 all of them, was told to change its state.
  void commanded(NodeId node, NmtCommand command);

 private:
  void heartbeat_changed(NodeId node, RemoteState state);
  void guarding_event(NodeId node, NodeGuardingEvent event, bool occurs);

  GatewayDevice& device_;
  Report report_;
  std::bitset<node_id_max + 1> heard_;  ///< nodes whose heartbeat comes
  std::array<NodeGuardingMaster::Slot, node_id_max> slots_;
  NodeGuardingMaster guarding_;
};

}  // namespace canvoy::gateway
