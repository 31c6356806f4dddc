// Node guarding by the NMT master: requests the NMT state of each node by remote frames, and
// detects a node that is silent or in an unexpected state (CiA 301, 7.2.8.2.2.1 and 7.2.8.3.2.1).
//
//     NodeGuardingMaster::Slot slots[4];
//     NodeGuardingMaster guarding(node, slots);
//     guarding.on_change(Callback<void(NodeId, RemoteState)>::to<&App::node_is>(app));
//     guarding.guard(5, 100ms, 3);
#pragma once

#include <span>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Reason of a node guarding event.
enum class NodeGuardingEvent : std::uint8_t {
  time_out,  ///< no valid answer within the node life time
  state,     ///< the node is in an NMT state that the master does not expect
};

/// Guards nodes. Each guarded node gets a remote frame once in its guard time, the first at once.
/// An answer without a change of the toggle bit does not count. A node without a valid answer for
/// guard time x life time factor is lost; requests to it continue, and its next answer is its
/// return. Its boot-up message counts as an answer, and the toggle bit starts again with 0.
///
/// Calls with a node-ID are linear in the number of slots; frames and time-outs are not.
///
/// An NMT reset of the master ends all guarding. It raises no error of its own node: the master
/// decides what a lost slave means.
class NodeGuardingMaster {
 public:
  /// The memory for one node that is guarded.
  class Slot {
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
    Timer timer_{callback<&Slot::expired>(*this)};
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

  /// Makes the service. The number of `slots` limits the guarded nodes; each needs a route. They
  /// must outlive this object.
  NodeGuardingMaster(Node& node, std::span<Slot> slots);
  NodeGuardingMaster(const NodeGuardingMaster&) = delete;
  NodeGuardingMaster& operator=(const NodeGuardingMaster&) = delete;

  /// Sets the callback for each change of a guarded node's state, its boot-up messages and its
  /// loss.
  void on_change(Callback<void(NodeId, RemoteState)> changed) { changed_ = changed; }
  /// Sets the callback for a node guarding event: when it occurs (true), and when it is resolved.
  void on_event(Callback<void(NodeId, NodeGuardingEvent, bool)> event) { event_ = event; }

  /// Guards a node, or changes its times. With a factor of 0 the node is asked for its state, but
  /// is never lost. False if the node-ID is invalid or the master's own, the guard time is zero or
  /// above 65,535 ms, or no slot or route is free.
  bool guard(NodeId node_id, Duration guard_time, std::uint8_t life_time_factor);
  /// Ends guarding of a node, without an event.
  void release(NodeId node_id);

  /// Notes that the master has commanded the node into `state`, which answers to later requests
  /// must report. Before, any state is accepted. No effect for a node that is not guarded.
  void expect(NodeId node_id, NmtState state);

  /// State of a node; unknown for a node that is not guarded.
  RemoteState state(NodeId node_id) const;
  /// True from guard() to release() or an NMT reset of the master.
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
  void notify(Slot& slot, NodeGuardingEvent event, bool& occurred, bool occurs);
  Slot* find(NodeId node_id) const;

  Node& node_;
  std::span<Slot> slots_;
  Callback<void(NodeId, RemoteState)> changed_;
  Callback<void(NodeId, NodeGuardingEvent, bool)> event_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
