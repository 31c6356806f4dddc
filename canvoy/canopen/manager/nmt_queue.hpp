// The NMT commands of a master: they leave in order, with at least the NMT inhibit time between
// two, and only when the controller has room (CiA 301, 102Ah).
//
//     NmtQueue::Request memory[128];
//     NmtQueue commands(node, memory);
//     commands.add({5, NmtCommand::start});
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// A queue of a fixed size, in memory of the owner.
class NmtQueue {
 public:
  static constexpr NodeId all_nodes = 0;  ///< the node-ID of a command that all obey

  /// A command that waits.
  struct Request {
    NodeId node = all_nodes;                 ///< node-ID, or all_nodes
    NmtCommand command = NmtCommand::start;  ///< command specifier
    bool spares_master = false;              ///< a command to all excludes this node
  };

  /// Makes the queue. `memory` is for waiting requests; it must outlive the queue.
  NmtQueue(Node& node, std::span<Request> memory);
  NmtQueue(const NmtQueue&) = delete;
  NmtQueue& operator=(const NmtQueue&) = delete;

  /// Adds a command, which is sent in a later call of the node, as soon as possible. A command for
  /// this node alone sends no frame. False if there is no room.
  bool add(Request request);

  /// Sets the callback for a command that is sent, called before this node obeys it.
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
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
