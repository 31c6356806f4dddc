// Updates a panel that the call controller receives again, or for the first time: after its
// boot-up, when it becomes operational, and when its heartbeat or its answers to node guarding
// return (CiA 301, 7.2.8; error 8130h ends). The inputs of the panel are read, and all outputs are
// sent, including those that are off, since a panel behind a cut cable still shows the last state.
// If this node itself is guarded again, all panels that it has received are updated.
//
//     ReturnedPanels returned(node, client, calls);
//     nmt_master.on_change(
//         Callback<void(NodeId, RemoteState)>::to<&ReturnedPanels::heard>(returned));
//
// After a sign of lost frames (GapWatch), ask_anew() does the same.
//
// Losses and returns that the node's own heartbeat consumer detects are taken automatically.
#pragma once

#include <bitset>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/devices/cia417/call/call_controller.hpp"
#include "canvoy/devices/cia417/call/panel_keys.hpp"

namespace canvoy::cia417 {

class ReturnedPanels {
 public:
  /// `client` has no other user. All arguments must outlive this.
  ReturnedPanels(Node& node, SdoClient& client, CallController& calls);

  /// Nodes for which the callback returns false have no inputs to read.
  void on_question(Callback<bool(NodeId)> has_inputs) { has_inputs_ = has_inputs; }
  /// Takes an error control message of a node, or its loss.
  void heard(NodeId panel, RemoteState state);
  /// Updates this panel, or all that were received (GapWatch::everyone): PDOs from and to them may
  /// have been lost.
  void ask_anew(NodeId panel);

  /// If several return at about the same time, their outputs are sent together.
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
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia417
