// Node guarding as the NMT master does it: asks each node by remote frames for its NMT state, and
// notices when one is silent or in another state than it should be (CiA 301, 7.2.8.2.2.1 and
// 7.2.8.3.2.1).
//
//     NodeGuardingMaster::Slot slots[4];
//     NodeGuardingMaster guarding(node, slots);
//     guarding.on_change(Callback<void(NodeId, RemoteState)>::to<&App::node_is>(app));
//     guarding.guard(5, 100ms, 3);
#pragma once

#include <span>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// Why the node guarding event occurs.
enum class NodeGuardingEvent : std::uint8_t {
  time_out,  ///< no good answer within the node life time
  state,     ///< the node is in another NMT state than the master expects
};

/// A remote frame goes to each guarded node once in its guard time, the first at once. An answer
/// of which the toggle bit did not change counts as none. A node without a good answer for guard
/// time x life time factor is lost; it is asked on, and its next answer is its return. Its boot-up
/// message counts as an answer, and the toggle bit begins anew with 0.
///
/// What is asked of it by a node-ID is linear in the number of slots; frames and time-outs are not.
///
/// An NMT reset of the master ends all guarding. It raises no error of its own node: what a lost
/// slave means is for the master to say.
class NodeGuardingMaster {
 public:
  class Slot;

  /// `slots` bounds the nodes that are guarded, each needs a route. They must outlive this.
  NodeGuardingMaster(Node& node, std::span<Slot> slots);
  NodeGuardingMaster(const NodeGuardingMaster&) = delete;
  NodeGuardingMaster& operator=(const NodeGuardingMaster&) = delete;

  /// Called for each change of a guarded node's state, its boot-up messages and its loss.
  void on_change(Callback<void(NodeId, RemoteState)> changed) { changed_ = changed; }
  /// Called when the node guarding event occurs (true), and when it is resolved.
  void on_event(Callback<void(NodeId, NodeGuardingEvent, bool)> event) { event_ = event; }

  /// Guards a node, from now on, or anew with other times. A factor of 0 asks the node for its
  /// state, but never takes it for lost. False where the node-ID is none or the master's own, the
  /// guard time is zero or above 65,535 ms, or no slot or route is free.
  bool guard(NodeId node_id, Duration guard_time, std::uint8_t life_time_factor);
  /// Ends it, without an event.
  void release(NodeId node_id);

  /// The master has commanded the node into `state`: answers to later requests are measured by it.
  /// Until then any state will do. Does nothing for a node that is not guarded.
  void expect(NodeId node_id, NmtState state);

  /// Of a node that is not guarded: unknown.
  RemoteState state(NodeId node_id) const;
  bool guards(NodeId node_id) const { return find(node_id) != nullptr; }

 private:
  void reset(ResetScope scope);
  void tx_ready();
  void poll(Slot& slot);
  void ask(Slot& slot);
  void arm(Slot& slot);
  void expired(Slot& slot, Time now);
  void received(Slot& slot, const Frame& frame, Time now);
  void enter(Slot& slot, RemoteState state);
  void compare(Slot& slot);
  void tell(Slot& slot, NodeGuardingEvent event, bool& occurred, bool occurs);
  Slot* find(NodeId node_id) const;

  Node& node_;
  std::span<Slot> slots_;
  Callback<void(NodeId, RemoteState)> changed_;
  Callback<void(NodeId, NodeGuardingEvent, bool)> event_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

/// The memory for one node that is guarded.
class NodeGuardingMaster::Slot {
 public:
  Slot() = default;
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;

 private:
  friend class NodeGuardingMaster;
  void received(const Frame& frame, Time now) { master_->received(*this, frame, now); }
  void expired(Time now) { master_->expired(*this, now); }
  Router::Receiver receiver() { return Router::Receiver::to<&Slot::received>(*this); }

  NodeGuardingMaster* master_ = nullptr;
  Timer timer_{Callback<void(Time)>::to<&Slot::expired>(*this)};
  Duration guard_time_{};
  Duration life_time_{};
  Time due_{};          ///< of the next request
  Time heard_{};        ///< of the last good answer, or of the begin
  NodeId node_id_ = 0;  ///< 0: free
  RemoteState state_ = RemoteState::unknown;
  RemoteState expected_ = RemoteState::unknown;  ///< unknown: any will do
  bool toggle_ = false;                          ///< of the next answer
  bool waits_ = false;                           ///< for room in the controller
  bool stale_ = false;  ///< what is expected was told after the last request
  bool timed_out_ = false;
  bool mismatched_ = false;
};

}  // namespace canvoy
