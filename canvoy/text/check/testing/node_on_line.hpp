// A node on the line of a conformance test, at exact virtual times, with a filter that may change,
// drop and add frames.
//
//     NodeOnLine on_line;
//     MasterNode<layout> master(on_line.port(), 1);
//     on_line.start(master.node());
//     Check check(on_line.line(), 1, {});
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/text/check/check.hpp"

namespace canvoy::conformance {

class NodeOnLine {
 public:
  NodeOnLine() = default;
  NodeOnLine(const NodeOnLine&) = delete;
  NodeOnLine& operator=(const NodeOnLine&) = delete;

  /// Port for the node.
  Port port() { return {this, &NodeOnLine::take, nullptr}; }
  /// Starts a node and discards its first frames. It must outlive the line.
  void start(Node& node) {
    node_ = &node;
    node.start(now_);
    run_until(now_ + 1s);
    queue_.clear();
  }

  /// The line to the node. This must outlive it.
  Line line() {
    return {.send =
                [this](const Frame& frame) {
                  if (is_bus_off) return false;
                  Frame sent = frame;
                  if (to_device(sent)) node_->receive(sent, now_);
                  return true;
                },
            .next = [this](Time until) { return next(until); },
            .now = [this] { return now_; }};
  }
  NodeId node() { return node_->id(); }
  Node& device() { return *node_; }
  Time now() const { return now_; }
  /// Adds a frame as if the device had sent it.
  void add(const Frame& frame) { queue_.push_back({now_, frame}); }

  /// Like add(), after this time; of several, the earliest must be added first.
  void add_later(Duration delay, const Frame& frame) { later_.push_back({now_ + delay, frame}); }

  /// Delivers a frame to the device, as if another node had sent it, past the filters.
  void deliver(const Frame& frame) { delivered_.push_back(frame); }

  /// Forgets what add_later() has added and is not yet due.
  void cancel_later() { later_.clear(); }

  /// Filters frames from the device; false: the frame is lost.
  std::function<bool(Frame&)> from_device = [](Frame&) { return true; };
  std::function<bool(Frame&)> to_device = [](Frame&) { return true; };
  bool is_bus_off = false;

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<NodeOnLine*>(context);
    Frame sent = frame;
    if (self.from_device(sent)) self.queue_.push_back({self.now_, sent});
    return true;
  }
  std::optional<Heard> next(Time until) {
    run_until(until);
    if (queue_.empty()) return std::nullopt;
    const Heard heard = queue_.front();
    queue_.pop_front();
    return heard;
  }
  /// Runs until this time, or until a frame is available.
  void run_until(Time until) {
    while (queue_.empty() && next_due() <= until) {
      now_ = std::max(now_, next_due());
      if (!delivered_.empty()) {
        const Frame frame = delivered_.front();
        delivered_.pop_front();
        node_->receive(frame, now_);
        continue;
      }
      if (due_later() <= now_) {
        queue_.push_back({now_, later_.front().frame});
        later_.pop_front();
      } else {
        node_->advance(now_);
      }
    }
    if (queue_.empty()) now_ = std::max(now_, until);
  }

  Time next_due() const {
    return delivered_.empty() ? std::min(node_->deadline(), due_later()) : now_;
  }
  Time due_later() const { return later_.empty() ? Time::max() : later_.front().time; }

  Node* node_ = nullptr;
  Time now_{};
  std::deque<Heard> queue_;
  std::deque<Heard> later_;
  std::deque<Frame> delivered_;
};

}  // namespace canvoy::conformance
