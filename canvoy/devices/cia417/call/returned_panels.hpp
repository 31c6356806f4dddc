// What a call controller does for a panel that it can hear again, or for the first time: after its
// boot-up, when it becomes operational, and when its heartbeat or its answers to node guarding come
// again (CiA 301, 7.2.8; error 8130h is gone). Its inputs are read, and all outputs told: what is
// off now as well, since a panel behind a cut cable goes on showing what it was told before. Where
// this node itself was guarded, and is again, all that it ever heard may have changed.
//
//     ReturnedPanels returned(node, client, calls);
//     nmt_master.on_change(Callback<void(NodeId,
//     RemoteState)>::to<&ReturnedPanels::heard>(returned));
//
// After a sign of lost frames (GapWatch) the same is done by ask_anew().
//
// Losses and returns that the node's own heartbeat consumer sees come here by themselves.
#pragma once

#include <bitset>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/call/panel_keys.hpp"

namespace canvoy::cia417 {

class ReturnedPanels {
 public:
  /// `client` is used by nobody else. All must outlive this.
  ReturnedPanels(Node& node, SdoClient& client, CallController& calls);
  ReturnedPanels(const ReturnedPanels&) = delete;
  ReturnedPanels& operator=(const ReturnedPanels&) = delete;

  /// Nodes for which it answers false have no inputs to be read.
  void on_question(Callback<bool(NodeId)> has_inputs) { has_inputs_ = has_inputs; }
  void heard(NodeId panel, RemoteState state);
  /// PDOs of this panel, or of all that were heard (GapWatch::everyone), may have been lost, and
  /// some to it.
  void ask_anew(NodeId panel);

  /// Where many come at one time, they are told together.
  static constexpr Duration tells_after = 200ms;

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void returned(NodeId panel);
  void tell();
  void expired(Time) { calls_.show_again(); }

  Node& node_;
  CallController& calls_;
  PanelKeys keys_;
  Callback<bool(NodeId)> has_inputs_;
  std::bitset<node_id_max + 1> heard_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia417
