#include "canvoy/canopen/nmt/nmt_master.hpp"

#include "canvoy/canopen/nmt/error_control_id.hpp"
#include "canvoy/canopen/nmt/network_states.hpp"

namespace canvoy {

constexpr ServiceHandlers NmtMaster::service_calls = {.reset = method<&NmtMaster::reset>};

NmtMaster::NmtMaster(Node& node, std::span<RemoteNode, node_id_max> nodes)
    : node_(node), nodes_(nodes) {
  NodeId id = node_id_min;
  for (RemoteNode& remote : nodes_) {
    remote.master_ = this;
    remote.id_ = id++;
    node_.router().add(error_control_id(remote.id_),
                       Router::Receiver::to<&RemoteNode::received>(remote));
  }
  node_.attach(service_);
}

bool NmtMaster::command(NodeId node_id, NmtCommand command) {
  return command_node(node_, node_id, command);
}

void NmtMaster::set_time_out(NodeId node_id, Duration time_out) {
  if (!is_node_id(node_id)) return;
  RemoteNode& remote = nodes_[node_id - std::size_t{1}];
  remote.time_out_ = time_out;
  if (time_out == Duration::zero()) node_.timers().disarm(remote.timer_);
}

void NmtMaster::reset(ResetScope) {
  for (RemoteNode& remote : nodes_) {
    node_.timers().disarm(remote.timer_);
    remote.state_ = RemoteState::unknown;
  }
}

void NmtMaster::received(RemoteNode& remote, const Frame& frame, Time now) {
  const RemoteState state = frame.length == 1 ? remote_state(frame.data[0]) : RemoteState::unknown;
  if (state == RemoteState::unknown) return node_.count_malformed();
  remote.seen_ = now;
  heard_(remote.id_, state);
  const bool watched = remote.time_out_ > Duration::zero();
  node_.timers().arm(remote.timer_, watched ? now + remote.time_out_ : never);
  enter(remote, state);
}

void NmtMaster::enter(RemoteNode& remote, RemoteState state) {
  if (state == remote.state_ && state != RemoteState::boot_up) return;
  remote.state_ = state;
  changed_(remote.id_, state);
}

}  // namespace canvoy
