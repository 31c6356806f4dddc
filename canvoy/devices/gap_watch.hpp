// Signs that frames of others may have been lost: what a controller knows by event-driven PDOs
// alone may be old then, though no heartbeat is late enough for a loss (CiA 301, 7.2.8.3.2.2).
//
//     GapWatch gaps(node, Callback<void(NodeId)>::to<&App::ask_anew>(app), rhythms);
//     gaps.heard(id, state);        // each heartbeat, where `rhythms` are given
//     gaps.heard(id, emergency);    // each emergency message
//
// The rule for all controllers: after a sign the state of the partner is asked anew (by remote
// frame where its PDO allows that, else by SDO), and the next command is built from the answer.
//
// Signs that concern everyone: the CAN controller of the node was error-passive or bus-off and is
// no longer, has reached or left its warning limit, or has lost frames (8110h). Signs that concern
// one node: its heartbeat comes half a period late, or it tells of trouble with its communication
// (81xxh). A gap between two heartbeats in which nobody sends in vain leaves no sign: a command
// that has no effect within its time is one as well, and is the controller's own.
#pragma once

#include <bitset>
#include <cstddef>
#include <span>

#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

class GapWatch {
 public:
  /// What `ask` is told where all partners are concerned.
  static constexpr NodeId everyone = 0;
  /// Signs are collected for so long, so that what waited on the bus has come before ...
  static constexpr Duration collects = 20ms;
  /// ... and `ask` is called no more often than this: a bus that is disturbed for long is not
  /// filled with questions.
  static constexpr Duration rests = 1s;

  /// When a node was heard last, and how long after the time before.
  struct Rhythm {
    Time at = never;
    Duration period{};
  };

  /// `ask` is called with a node-ID, or `everyone`, in NMT state operational. `rhythms` are those
  /// of node-IDs 1 and up; without them heartbeats are no signs. Both must outlive this.
  GapWatch(Node& node, Callback<void(NodeId)> ask, std::span<Rhythm> rhythms = {});
  GapWatch(const GapWatch&) = delete;
  GapWatch& operator=(const GapWatch&) = delete;

  /// An error control message of a node.
  void heard(NodeId id, RemoteState state);
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
  std::bitset<node_id_max + 1> suspects_;  ///< bit 0: everyone
  Time asked_at_ = never;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy
