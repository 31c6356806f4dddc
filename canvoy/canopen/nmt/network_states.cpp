#include "canvoy/canopen/nmt/network_states.hpp"

#include "canvoy/canopen/nmt/error_control_id.hpp"

namespace canvoy {

bool command_node(Node& node, NodeId node_id, NmtCommand command) {
  if (node_id > node_id_max || node.state() == NmtState::initialisation) return false;
  const Frame frame = Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(command), node_id});
  if (node_id != node.id() && !node.transmitter().send(frame)) return false;
  if (node_id == 0 || node_id == node.id()) node.command(command);
  return true;
}

NetworkStates::NetworkStates(Node& node) : NodeService({on_event}, EventMask::none), node_(node) {
  states_.fill(RemoteState::unknown);
  can_id_ = every_id;
  for (NodeId id = node_id_min; id <= node_id_max; ++id) {
    if constexpr (is_small_machine) {
      node_.router().filter(error_control_id(id), true);
    } else {
      node_.router().add(error_control_id(id),
                         Router::Receiver::to<&NetworkStates::received>(*this));
    }
  }
  node_.attach(*this);
}

void NetworkStates::on_event(NodeService& service, ServiceEvent& event) {
  NetworkStates& self = static_cast<NetworkStates&>(service);
  if (event.kind == ServiceEvent::reset) return self.states_.fill(RemoteState::unknown);
  if (!is_small_machine || event.kind != ServiceEvent::frame_came) return;
  const Frame& frame = event.frame();
  if (frame.is_remote() || frame.id <= can_id::error_control) return;
  if (frame.id > error_control_id(node_id_max)) return;
  event.want();
  self.received(frame, self.node_.now());
}

void NetworkStates::received(const Frame& frame, Time) {
  const auto id = static_cast<NodeId>(frame.id - can_id::error_control);
  const RemoteState state = frame.length == 1 ? remote_state(frame.data[0]) : RemoteState::unknown;
  if (state == RemoteState::unknown) return node_.count_malformed();
  RemoteState& known = states_[id - std::size_t{1}];
  if (state == known && state != RemoteState::boot_up) return;
  known = state;
  changed_(id, state);
}

}  // namespace canvoy
