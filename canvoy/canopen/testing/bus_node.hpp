// Nodes on a simulated bus with the timing of a real one, for tests.
//
//     SimulatedBus bus({.bit_rate = 1'000'000});
//     BusNode node(bus, tables, 5);
//     run(bus, nodes, [&] { return done; });
//
// For tests only.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

/// A node with a controller on `bus`. The test constructs services on `node`.
class BusNode : private WireMemory {
 public:
  BusNode(SimulatedBus& bus, const DictionaryTables& tables, NodeId id,
          std::size_t backlog_size = 16)
      : WireMemory(tables, backlog_size),
        controller(bus.attach({.listener = {.context = this,
                                            .on_frame = &BusNode::receive,
                                            .on_sent = &BusNode::sent}})),
        tables_(tables),
        node(tables_, spans(), bus.port(controller), id) {}
  BusNode(const BusNode&) = delete;
  BusNode& operator=(const BusNode&) = delete;

  const ControllerId controller;

 private:
  static void receive(void* context, Time now, const Frame& frame) {
    static_cast<BusNode*>(context)->node.receive(frame, now);
  }
  static void sent(void* context, Time now, const Frame&) {
    static_cast<BusNode*>(context)->node.tx_ready(now);
  }

  DictionaryTables tables_;

 public:
  Node node;
};

/// Advances time until `done`, nothing is left to happen, or 10 minutes are over; returns whether
/// it is done.
template <class Nodes, class Done>
bool run(SimulatedBus& bus, const Nodes& nodes, Done done) {
  while (!done()) {
    Time next = bus.next_event();
    for (const auto& node : nodes) next = std::min(next, node->node.deadline());
    if (next > Time(10min)) return false;
    next = std::max(next, bus.now());
    bus.advance(next);
    for (const auto& node : nodes) {
      while (node->node.deadline() <= next) node->node.advance(next);
    }
  }
  return true;
}

}  // namespace canvoy
