#include "canvoy/devices/cia407/kit/network_start.hpp"

namespace canvoy::cia407 {

constexpr ServiceHandlers NetworkStart::service_calls = {.reset = method<&NetworkStart::reset>};

NetworkStart::NetworkStart(Node& node)
    : node_(node), master_(node, remotes_), timer_(callback<&NetworkStart::look>(*this)) {
  master_.on_change(callback<&NetworkStart::changed>(*this));
  node.attach(service_);
}

void NetworkStart::reset(ResetScope /*scope*/) {
  node_.timers().arm(timer_, node_.now());
}

/// A pre-operational node starts for the first time, or after an error of its own (1029h). A
/// stopped node was stopped on purpose.
void NetworkStart::look(Time now) {
  node_.timers().arm(timer_, now + period);
  if (node_.state() == NmtState::pre_operational) {
    master_.command(NmtMaster::all_nodes, NmtCommand::enter_pre_operational);
    master_.command(NmtMaster::all_nodes, NmtCommand::start);
  }
  for (NodeId id = node_id_min; id <= node_id_max; ++id) changed(id, master_.remote(id).state());
}

void NetworkStart::changed(NodeId id, RemoteState state) {
  const bool waits = state == RemoteState::boot_up || state == RemoteState::pre_operational ||
                     state == RemoteState::stopped;
  if (waits && node_.state() == NmtState::operational) master_.command(id, NmtCommand::start);
}

}  // namespace canvoy::cia407
