// Heartbeat consumer: monitors the nodes in 1016h, and reports the loss of one (CiA 301,
// 7.2.8.3.2.2 and 7.5.2.19).
//
//     HeartbeatConsumer::Slot slots[4];
//     HeartbeatConsumer consumer(node, slots);
//     consumer.on_change(Callback<void(NodeId, RemoteState)>::to<&App::partner_is>(app));
#pragma once

#include <span>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Monitors nodes. A node that stays silent for longer than its time in 1016h raises error 8130h
/// with the node-ID as instance; its next heartbeat clears the error.
///
/// Monitoring of a node starts with its first heartbeat. Its boot-up message alone does not start
/// it, since a node may boot long before its heartbeat is enabled; a node that is monitored already
/// stays so when it boots again. Monitoring continues in NMT state stopped, where error control is
/// active too.
///
/// A new time for the same node applies from the write on; the node's state stays as it was until
/// the next heartbeat, and a lost node stays lost.
class HeartbeatConsumer {
 public:
  /// Moment from which on a node must send heartbeats.
  enum class Start : std::uint8_t {
    first_heartbeat,  ///< as CiA 301 requires
    configuration,    ///< when 1016h is set, so that a node that never appears is lost as well
  };

  /// The memory for the supervision of one node.
  class Slot {
   public:
    Slot() = default;
    Slot(const Slot&) = delete;
    Slot& operator=(const Slot&) = delete;

   private:
    friend class HeartbeatConsumer;
    void received(const Frame& frame, Time now) { consumer_->received(*this, frame, now); }
    void expired(Time) { consumer_->enter(*this, RemoteState::lost); }
    Router::Receiver receiver() { return Router::Receiver::to<&Slot::received>(*this); }

    HeartbeatConsumer* consumer_ = nullptr;
    Timer timer_{callback<&Slot::expired>(*this)};
    Duration time_{};
    NodeId node_id_ = 0;  ///< 0: not in use
    RemoteState state_ = RemoteState::unknown;
  };

  /// `slots` serve sub-indices 1 and up of 1016h, each needs a route. They must outlive the
  /// consumer.
  HeartbeatConsumer(Node& node, std::span<Slot> slots, Start start = Start::first_heartbeat);
  HeartbeatConsumer(const HeartbeatConsumer&) = delete;
  HeartbeatConsumer& operator=(const HeartbeatConsumer&) = delete;

  /// Sets the callback for each change of a monitored node's state, its boot-up messages and its
  /// loss; it is called after the error was raised or cleared.
  void on_change(Callback<void(NodeId, RemoteState)> changed) { changed_ = changed; }

  /// State of a node; unknown for a node that is not in 1016h.
  RemoteState state(NodeId node_id) const;

 private:
  void reset(ResetScope scope);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void configure(std::size_t position);
  void release(Slot& slot);
  void received(Slot& slot, const Frame& frame, Time now);
  void enter(Slot& slot, RemoteState state);

  Node& node_;
  std::span<Slot> slots_;
  Start start_;
  Callback<void(NodeId, RemoteState)> changed_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
