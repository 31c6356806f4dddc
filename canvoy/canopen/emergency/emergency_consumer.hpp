// Emergency consumer: receives the emergency messages of other nodes (CiA 301, 7.2.7 and 1028h).
//
//     EmergencyConsumer::Slot slots[2];
//     EmergencyConsumer consumer(node, slots);
//     consumer.on_emergency(Callback<void(NodeId, const Emergency&)>::to<&App::heard>(app));
//     consumer.listen(5);
#pragma once

#include <span>

#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Receives the messages of the nodes in 1028h, where the sub-index is the node-ID, and of those
/// added by listen(); in NMT states pre-operational and operational.
class EmergencyConsumer {
 public:
  /// The memory for one node that is heard.
  class Slot {
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

  /// Makes the consumer. The number of `slots` limits the nodes that are received; each needs a
  /// route. They must outlive the consumer.
  EmergencyConsumer(Node& node, std::span<Slot> slots);
  EmergencyConsumer(const EmergencyConsumer&) = delete;
  EmergencyConsumer& operator=(const EmergencyConsumer&) = delete;

  /// Sets the callback for each message, with the node-ID of its sender; code 0000h: an error has
  /// disappeared.
  void on_emergency(Callback<void(NodeId, const Emergency&)> heard) { heard_ = heard; }

  /// Receives messages of node `node_id` on its pre-defined CAN-ID, 080h + node-ID, or on another
  /// one, until ignore(), also after resets. False if the node-ID is invalid, or no slot is free.
  bool listen(NodeId node_id) {
    return listen(node_id, static_cast<std::uint16_t>(can_id::emergency + node_id));
  }
  /// Like the above, on a CAN-ID of 11 bits. False also if it is above 7FFh or no route is free.
  bool listen(NodeId node_id, std::uint16_t can_id);
  /// Ends the reception that listen() began.
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
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
