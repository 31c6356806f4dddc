// The NMT states of all other nodes by their boot-up messages and heartbeats, in one byte each: for
// applications that watch for new nodes. Monitoring needs a HeartbeatConsumer, booting an
// NmtMaster.
//
//     NetworkStates network(node);
//     network.on_change(
//         Callback<void(NodeId, RemoteState)>::to<&Charger::network_changed>(charger));
//     command_node(node, 5, NmtCommand::start);
#pragma once

#include <array>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Sends an NMT command as a master does, to node `node_id` or to all (0). The sender obeys as well
/// if it is addressed, as a node does not receive its own frames. False if the node-ID is above
/// 127, the sender is in initialisation, or the command could not be sent.
bool command_node(Node& node, NodeId node_id, NmtCommand command);

/// NMT states of nodes 1 to 127. Needs no object in the dictionary, and takes 127 routes on a host.
class NetworkStates : private NodeService {
 public:
  /// Number of routes: one for each of 127 node-IDs, none on a small machine.
  static constexpr std::size_t routes = is_small_machine ? 0 : node_id_max;

  /// Attaches to the node, and takes its routes. A node-ID without a free route stays unknown.
  explicit NetworkStates(Node& node);

  /// Sets the callback for each change of a node's state, and its boot-up messages.
  void on_change(Callback<void(NodeId, RemoteState)> changed) { changed_ = changed; }

  /// State of a node; `node_id` is 1 to 127. All are unknown after a reset of this node; none is
  /// ever lost.
  RemoteState state(NodeId node_id) const { return states_[node_id - std::size_t{1}]; }

 private:
  static void on_event(NodeService& service, ServiceEvent& event);
  void received(const Frame& frame, Time now);

  Node& node_;
  Callback<void(NodeId, RemoteState)> changed_;
  std::array<RemoteState, node_id_max> states_;
};

}  // namespace canvoy
