#include "canvoy/devices/cia417/call/returned_panels.hpp"

#include "canvoy/devices/kit/gap_watch.hpp"

namespace canvoy::cia417 {

constexpr ServiceHandlers ReturnedPanels::service_calls = {
    .reset = method<&ReturnedPanels::reset>,
    .state_entered = method<&ReturnedPanels::state_entered>,
    .error_changed = method<&ReturnedPanels::error_changed>};

ReturnedPanels::ReturnedPanels(Node& node, SdoClient& client, CallController& calls)
    : node_(node),
      calls_(calls),
      keys_(node, client, calls),
      timer_(callback<&ReturnedPanels::expired>(*this)) {
  node.attach(service_);
}

void ReturnedPanels::reset(ResetScope) {
  heard_.reset();
  node_.timers().disarm(timer_);
}

/// Panels do not repeat the records that they sent while this node received no PDOs.
void ReturnedPanels::state_entered(NmtState state) {
  if (state == NmtState::operational) ask_anew(GapWatch::everyone);
}

void ReturnedPanels::ask_anew(NodeId panel) {
  for (unsigned id = 1; id <= node_id_max; ++id) {
    const bool is_meant = panel == GapWatch::everyone || panel == id;
    if (is_meant && heard_[id]) returned(static_cast<NodeId>(id));
  }
}

/// A node that boots receives PDOs soon, and answers requests after it has been started.
void ReturnedPanels::heard(NodeId panel, RemoteState state) {
  if (state == RemoteState::boot_up) tell();
  if (state == RemoteState::operational) returned(panel);
}

void ReturnedPanels::error_changed(const Error& error, bool present) {
  constexpr std::uint16_t own_life_guarding = 0;
  if (error.code != canvoy::emergency_code::heartbeat || present) return;
  if (error.instance == own_life_guarding) return ask_anew(GapWatch::everyone);
  if (is_node_id(error.instance)) returned(static_cast<NodeId>(error.instance));
}

void ReturnedPanels::returned(NodeId panel) {
  heard_[panel] = true;
  if (!has_inputs_ || has_inputs_(panel)) keys_.read(panel);
  tell();
}

void ReturnedPanels::tell() {
  if (!timer_.armed()) node_.timers().arm(timer_, node_.now() + tells_after);
}

}  // namespace canvoy::cia417
