// For tests: a node that records the events of its controller.
//
//     BusTestNode node(bus);
//     node.send(Frame::data_frame(0x080, {}));
//     EXPECT_EQ(node.received, ...);
#pragma once

#include <ostream>
#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"

namespace canvoy {

/// A frame and its time, for comparison and printing in tests.
struct TimedFrame {
  Duration at{};
  Frame frame{};

  friend bool operator==(const TimedFrame&, const TimedFrame&) = default;
  friend std::ostream& operator<<(std::ostream& out, const TimedFrame& timed) {
    out << timed.at.count() << " us " << std::hex << timed.frame.id << std::dec << "#";
    for (const std::uint8_t byte : timed.frame.payload()) out << int{byte} << ' ';
    return out;
  }
};

struct TimedState {
  Duration at{};
  BusState state = BusState::error_active;

  friend bool operator==(const TimedState&, const TimedState&) = default;
  friend std::ostream& operator<<(std::ostream& out, const TimedState& timed) {
    return out << timed.at.count() << " us state " << static_cast<int>(timed.state);
  }
};

class BusTestNode {
 public:
  explicit BusTestNode(SimulatedBus& bus, ControllerOptions options = {}) : bus_(bus) {
    options.listener = {.context = this,
                        .on_frame = &BusTestNode::on_frame,
                        .on_sent = &BusTestNode::on_sent,
                        .on_state = &BusTestNode::on_state};
    id = bus.attach(options);
  }
  BusTestNode(const BusTestNode&) = delete;
  BusTestNode& operator=(const BusTestNode&) = delete;

  bool send(const Frame& frame) { return bus_.send(id, frame); }
  int tec() const { return bus_.error_counters(id).transmit(); }
  int rec() const { return bus_.error_counters(id).receive(); }
  BusState state() const { return bus_.state(id); }

  ControllerId id = no_controller;
  std::vector<TimedFrame> received;
  std::vector<TimedFrame> sent;
  std::vector<TimedState> states;

 private:
  static BusTestNode& self(void* context) { return *static_cast<BusTestNode*>(context); }
  static void on_frame(void* context, Time now, const Frame& frame) {
    self(context).received.push_back({now.time_since_epoch(), frame});
  }
  static void on_sent(void* context, Time now, const Frame& frame) {
    self(context).sent.push_back({now.time_since_epoch(), frame});
  }
  static void on_state(void* context, Time now, BusState state) {
    self(context).states.push_back({now.time_since_epoch(), state});
  }

  SimulatedBus& bus_;
};

}  // namespace canvoy
