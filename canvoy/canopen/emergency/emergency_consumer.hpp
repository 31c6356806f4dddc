// Emergency consumer: hears the emergency messages of other nodes (CiA 301, 7.2.7 and 1028h).
//
//     EmergencyConsumer::Slot slots[2];
//     EmergencyConsumer consumer(node, slots);
//     consumer.on_emergency(Callback<void(NodeId, const Emergency&)>::to<&App::heard>(app));
//     consumer.listen(5);
#pragma once

#include <span>

#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

/// It hears the nodes that 1028h names, where the sub-index is the node-ID, and those that the
/// application asked for by listen(); in NMT states pre-operational and operational.
class EmergencyConsumer {
 public:
  class Slot;

  /// `slots` bounds the nodes that are heard, each needs a route. They must outlive the consumer.
  EmergencyConsumer(Node& node, std::span<Slot> slots);
  EmergencyConsumer(const EmergencyConsumer&) = delete;
  EmergencyConsumer& operator=(const EmergencyConsumer&) = delete;

  void on_emergency(Callback<void(NodeId, const Emergency&)> heard) { heard_ = heard; }

  /// Hears node `node_id` by its pre-defined CAN-ID, 080h + node-ID, or by another one, from now on
  /// and after every reset. False where the node-ID is none, or no slot is free.
  bool listen(NodeId node_id) {
    return listen(node_id, static_cast<std::uint16_t>(can_id::emergency + node_id));
  }
  bool listen(NodeId node_id, std::uint16_t can_id);
  /// Ends what listen() began.
  void ignore(NodeId node_id);

 private:
  void reset(ResetScope scope);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void configure(NodeId node_id);
  bool hear(NodeId node_id, std::uint16_t can_id, bool by_application);
  void release(NodeId node_id, bool by_application);
  void received(const Slot& slot, const Frame& frame);

  Node& node_;
  std::span<Slot> slots_;
  Callback<void(NodeId, const Emergency&)> heard_;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;
  ServiceLink service_{&service_calls, this};
};

/// The memory for one node that is heard.
class EmergencyConsumer::Slot {
 public:
  Slot() = default;
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;

 private:
  friend class EmergencyConsumer;
  void received(const Frame& frame, Time) { consumer_->received(*this, frame); }
  Router::Receiver receiver() { return Router::Receiver::to<&Slot::received>(*this); }

  EmergencyConsumer* consumer_ = nullptr;
  std::uint16_t can_id_ = 0;
  NodeId node_id_ = 0;  ///< 0: free
  bool by_application_ = false;
};

}  // namespace canvoy
