// A bus on which answers arrive during the call that sends the request, as on a controller that
// loops frames back, or in a simulation without time.
//
//     PromptBus bus(dynamic_sdo_manager(), 1);
//     bus.answers = [](const Frame& frame) { return sdo_confirmation(frame); };
//
// For tests only.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

class PromptBus : private WireMemory {
 public:
  PromptBus(const DictionaryTables& tables, NodeId id)
      : WireMemory(tables),
        tables_(tables),
        node(tables_, spans(), {this, &PromptBus::take, nullptr}, id) {
    node.start(now);
  }

  void receive(std::string_view frame) {
    node.receive(wire_frame(frame), now);
    run_for(Duration::zero());
  }
  void run_for(Duration duration) {
    const Time until = now + duration;
    for (int i = 0; node.deadline() <= until; ++i) {
      ASSERT_LT(i, 10'000) << "the node wants to be called again and again";
      now = std::max(now, node.deadline());
      node.advance(now);
    }
    now = until;
  }

  /// Answer of the other nodes to a frame, if any.
  std::function<std::optional<Frame>(const Frame&)> answers;
  std::vector<std::string> sent;
  Time now{};

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<PromptBus*>(context);
    self.sent.push_back(wire_text(frame));
    const std::optional<Frame> answer = self.answers ? self.answers(frame) : std::nullopt;
    if (answer) self.node.receive(*answer, self.now);
    return true;
  }

  DictionaryTables tables_;

 public:
  Node node;
};

}  // namespace canvoy
