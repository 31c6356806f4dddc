// Detects signs of lost frames: the state that a controller has from event-driven PDOs may then be
// out of date, although no heartbeat is late enough for a loss (CiA 301, 7.2.8.3.2.2).
//
//     GapWatch gaps(node, Callback<void(NodeId)>::to<&App::ask_anew>(app), rhythms);
//     gaps.heard(id, state);        // each heartbeat, where `rhythms` are given
//     gaps.heard(id, emergency);    // each emergency message
//
// The rule for all controllers: after a sign, the state of the partner is requested (by remote
// frame if its PDO allows that, otherwise by SDO), and the next command follows from the answer.
//
// Signs for all partners: the CAN controller of the node has left error-passive or bus-off, has
// reached or left its warning limit, or has lost frames (8110h). Signs for one node: its heartbeat
// comes half a period late, or it reports a communication error (81xxh). A gap between two
// heartbeats without a failed transmission leaves no sign: a command without effect within its time
// is one as well, and the controller itself detects it.
#pragma once

#include <bitset>
#include <cstddef>
#include <span>

#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

class GapWatch {
 public:
  /// Argument of `ask` for all partners.
  static constexpr NodeId everyone = 0;
  /// Signs are collected for this time, so that frames that wait on the bus have arrived ...
  static constexpr Duration collects = 20ms;
  /// ... and `ask` is called at most once in this time, so that requests do not fill a bus that is
  /// disturbed for long.
  static constexpr Duration rests = 1s;

  /// When a node was last received, and how long after the time before.
  struct Rhythm {
    Time at = never;    ///< when it was last received
    Duration period{};  ///< from the time before to then
  };

  /// `ask` is called with a node-ID, or `everyone`, in NMT state operational. `rhythms` are those
  /// of node-IDs 1 and up; without them, heartbeats are no signs. Both must outlive this.
  GapWatch(Node& node, Callback<void(NodeId)> ask, std::span<Rhythm> rhythms = {});

  /// Takes an error control message of a node.
  void heard(NodeId id, RemoteState state);
  /// Takes an emergency message of a node: a communication error is a sign.
  void heard(NodeId id, const Emergency& emergency);

 private:
  void reset(ResetScope scope);
  void bus_state_changed(BusState state);
  void error_changed(const Error& error, bool present);
  void suspect(NodeId id);
  void expired(Time now);

  Node& node_;
  Callback<void(NodeId)> ask_;
  std::span<Rhythm> rhythms_;
  std::bitset<node_id_max + 1> suspects_;  ///< bit 0: all nodes
  Time asked_at_ = never;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy
