// Connects a node to a bus and to the loop: passes frames, bus states and time to it, and its
// frames to the bus.
//
//     Attachment attachment(loop, bus);
//     Node node(attachment.port(), ...);
//     attachment.attach(node);
#pragma once

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"

namespace canvoy::host {

/// The connection. Loop and bus must outlive it. The node must be constructed after it, since it
/// needs the port, and destroyed before it; the loop must not run in between.
class Attachment {
 public:
  /// Joins the bus; nothing is received before attach().
  Attachment(EventLoop& loop, HostBus& bus) : loop_(&loop), bus_(&bus), endpoint_(&bus.join()) {}
  ~Attachment() {
    bus_->leave(*endpoint_);
    if (task_ != 0) loop_->remove(task_);
  }
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// Port for the node; its frames go to the bus.
  Port port() { return endpoint_->port(); }

  /// Passes to the node everything that it has a member function for: receive(const Frame&, Time),
  /// bus_state(BusState, Time), tx_ready(Time), and deadline() with advance(Time). To be called
  /// once.
  template <class Node>
  void attach(Node& node) {
    endpoint_->attach(member_of(node));
    if constexpr (requires(Node& n, Time t) { n.advance(t), Time(n.deadline()); }) {
      Task task;
      task.deadline = {
          [](void* context) -> Time { return static_cast<Node*>(context)->deadline(); }, &node};
      task.advance = {[](void* context, Time now) { static_cast<Node*>(context)->advance(now); },
                      &node};
      task_ = loop_->add(task);
    }
  }

 private:
  template <class Node>
  static BusMember member_of(Node& node) {
    BusMember member;
    if constexpr (requires(Node& n, const Frame& f, Time t) { n.receive(f, t); }) {
      member.receive = {[](void* context, const Frame& frame, Time time) {
                          static_cast<Node*>(context)->receive(frame, time);
                        },
                        &node};
    }
    if constexpr (requires(Node& n, BusState s, Time t) { n.bus_state(s, t); }) {
      member.bus_state = {[](void* context, BusState state, Time time) {
                            static_cast<Node*>(context)->bus_state(state, time);
                          },
                          &node};
    }
    if constexpr (requires(Node& n, Time t) { n.tx_ready(t); }) {
      member.tx_ready = {
          [](void* context, Time time) { static_cast<Node*>(context)->tx_ready(time); }, &node};
    }
    return member;
  }

  EventLoop* loop_;
  HostBus* bus_;
  HostBus::Endpoint* endpoint_;
  EventLoop::Id task_ = 0;
};

}  // namespace canvoy::host
