// A simple NMT master: commands the other nodes, and tracks their states (CiA 301, 7.2.8). It
// starts no node by itself, and does not implement boot-up by 1F80h and 1F81h (CiA 302-2).
//
//     NmtMaster::RemoteNode nodes[127];
//     NmtMaster master(node, nodes);
//     master.command(5, NmtCommand::start);
#pragma once

#include <span>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// An NMT master without a start-up of its own. A route is needed for each of 127 node-IDs.
class NmtMaster {
 public:
  static constexpr NodeId all_nodes = 0;  ///< the node-ID of a command that all obey

  /// What the master knows of one node.
  class RemoteNode {
   public:
    RemoteNode() = default;
    RemoteNode(const RemoteNode&) = delete;
    RemoteNode& operator=(const RemoteNode&) = delete;

    /// Node-ID, 1 to 127.
    NodeId id() const { return id_; }
    /// What its last message reported; lost after the time-out.
    RemoteState state() const { return state_; }
    /// When its last boot-up message or heartbeat came; meaningless while it is unknown.
    Time seen() const { return seen_; }

   private:
    friend class NmtMaster;
    void received(const Frame& frame, Time now) { master_->received(*this, frame, now); }
    void expired(Time) { master_->enter(*this, RemoteState::lost); }

    NmtMaster* master_ = nullptr;
    Timer timer_{callback<&RemoteNode::expired>(*this)};
    Time seen_{};
    Duration time_out_{};
    RemoteState state_ = RemoteState::unknown;
    NodeId id_ = 0;
  };

  /// `nodes` are node-IDs 1 to 127, each needs a route. They must outlive the master.
  NmtMaster(Node& node, std::span<RemoteNode, node_id_max> nodes);
  NmtMaster(const NmtMaster&) = delete;
  NmtMaster& operator=(const NmtMaster&) = delete;

  /// Sets the callback for each change of a node's state, its boot-up messages and its loss.
  void on_change(Callback<void(NodeId, RemoteState)> changed) { changed_ = changed; }
  /// Sets the callback for each boot-up message, heartbeat and answer to node guarding. It is
  /// called before on_change; a time-out that it sets applies from this message on.
  void on_message(Callback<void(NodeId, RemoteState)> heard) { heard_ = heard; }

  /// Commands node `node_id`, or all. The master obeys as well if it is addressed, as a node does
  /// not receive its own frames. False if the node-ID is above 127, or the command could not be
  /// sent.
  bool command(NodeId node_id, NmtCommand command);

  /// Sets the time after which a node that was heard before is lost if it stays silent; 0 (the
  /// default): never. Applies from the node's next message on.
  void set_time_out(NodeId node_id, Duration time_out);

  /// State of a node; `node_id` is 1 to 127. All are unknown after a reset of the master.
  const RemoteNode& remote(NodeId node_id) const;

 private:
  void reset(ResetScope scope);
  void received(RemoteNode& remote, const Frame& frame, Time now);
  void enter(RemoteNode& remote, RemoteState state);

  Node& node_;
  std::span<RemoteNode, node_id_max> nodes_;
  Callback<void(NodeId, RemoteState)> changed_;
  Callback<void(NodeId, RemoteState)> heard_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

inline const NmtMaster::RemoteNode& NmtMaster::remote(NodeId node_id) const {
  return nodes_[node_id - std::size_t{1}];
}

}  // namespace canvoy
