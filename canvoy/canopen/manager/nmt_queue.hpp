// The NMT commands of a master on their way: they leave in their order, with at least the NMT
// inhibit time between two (CiA 301, 102Ah), and only when the controller has room.
//
//     NmtQueue::Request memory[128];
//     NmtQueue commands(node, memory);
//     commands.add({5, NmtCommand::start});
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"

namespace canvoy {

class NmtQueue {
 public:
  static constexpr NodeId all_nodes = 0;

  struct Request {
    NodeId node = all_nodes;
    NmtCommand command = NmtCommand::start;
    bool spares_master = false;  ///< a command to all does not mean this node
  };

  /// `memory` is for requests that wait; it must outlive the queue.
  NmtQueue(Node& node, std::span<Request> memory);
  NmtQueue(const NmtQueue&) = delete;
  NmtQueue& operator=(const NmtQueue&) = delete;

  /// The command is sent from a later call of the node, at once where nothing hinders it. What is
  /// meant for this node alone sends no frame. False where there is no room.
  bool add(Request request);

  /// Called when a command is on its way, before this node obeys it.
  void on_sent(Callback<void(const Request&)> sent) { sent_ = sent; }

  bool empty() const { return size_ == 0; }

 private:
  void reset(ResetScope scope);
  void tx_ready();
  void send_due(Time now);
  void send(const Request& request);

  Node& node_;
  std::span<Request> memory_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  Time inhibited_until_{};
  Callback<void(const Request&)> sent_;
  Timer timer_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
