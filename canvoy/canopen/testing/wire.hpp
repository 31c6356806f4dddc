// A small language for tests at the wire: frames in, frames out, at exact virtual times.
//
//     WireNode node(tables, 5);
//     node.start();
//     node.expect({"705#00"});
//     node.receive("605#40 00 10 00 00 00 00 00");
//     node.expect({"585#43 00 10 00 A3 01 00 00"});
//     node.run_until(Time(200ms));
//
// For tests only: it allocates, and reports to GoogleTest.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// Reads `123#11 22`, `123#R`, `123#R8`, `00000123#` (29 bits); ignores blanks.
inline Frame wire_frame(std::string_view text) {
  const auto separator = text.find('#');
  const std::string id(text.substr(0, separator));
  std::string body;
  for (const char c : text.substr(separator + 1)) {
    if (c != ' ') body += c;
  }
  Frame frame;
  frame.id = static_cast<std::uint32_t>(std::stoul(id, nullptr, 16));
  if (id.size() > 3) frame.flags = FrameFlags::extended;
  if (body.starts_with('R')) {
    frame.flags = frame.flags | FrameFlags::remote;
    frame.length = body.size() > 1 ? static_cast<std::uint8_t>(body[1] - '0') : std::uint8_t{0};
    return frame;
  }
  frame.length = static_cast<std::uint8_t>(body.size() / 2);
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data.at(i) = static_cast<std::uint8_t>(std::stoul(body.substr(2 * i, 2), nullptr, 16));
  }
  return frame;
}

/// Text of a frame, in the one form that comparisons use: `705#00`, `581#43 00 10 00`.
inline std::string wire_text(const Frame& frame) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, frame.is_extended() ? "%08X#" : "%03X#", frame.id);
  std::string text = buffer;
  if (frame.is_remote())
    return text + "R" + (frame.length != 0 ? std::to_string(frame.length) : "");
  for (std::size_t i = 0; i < frame.length; ++i) {
    std::snprintf(buffer, sizeof buffer, "%s%02X", i == 0 ? "" : " ", frame.data.at(i));
    text += buffer;
  }
  return text;
}

/// Memory of a node, from the heap, with ample room for everything.
struct WireMemory {
  explicit WireMemory(const DictionaryTables& tables, std::size_t backlog_size = 16)
      : values(tables.value_bytes),
        states(tables.objects.size()),
        routes(1200),
        backlog(backlog_size) {}
  NodeMemory spans() { return {values, states, routes, backlog}; }

  std::vector<std::uint8_t> values;
  std::vector<ObjectState> states;
  std::vector<Router::Route> routes;
  std::vector<Frame> backlog;
};

/// A node of which the test is the bus. The test constructs services on `node`.
class WireNode : private WireMemory {
 public:
  WireNode(const DictionaryTables& tables, NodeId id, bool autostart = false,
           std::size_t backlog_size = 16)
      : WireMemory(tables, backlog_size),
        tables_(tables),
        node(tables_, spans(), {this, &WireNode::take, nullptr}, id, autostart) {}

  void start() { node.start(now); }
  /// Starts the node and discards its boot-up message.
  void boot() {
    node.start(now);
    sent.clear();
  }
  /// Like boot(), but up to NMT state operational; frames sent then are kept.
  void boot_operational() {
    boot();
    receive("000#01 00");
  }

  void receive(std::string_view frame) {
    node.receive(wire_frame(frame), now);
    settle();
  }
  /// Lets the node do what is due at `now`.
  void settle() {
    for (int i = 0; node.deadline() <= now; ++i) {
      ASSERT_LT(i, 10'000) << "the node wants to be called again and again";
      node.advance(now);
    }
  }
  /// Advances virtual time to `until`; the node is called at its deadlines, and each frame is
  /// recorded with its time.
  void run_until(Time until) {
    while (node.deadline() <= until) {
      now = node.deadline() > now ? node.deadline() : now;
      settle();
    }
    now = until;
  }
  void run_for(Duration duration) { run_until(now + duration); }
  /// From now on the controller takes nothing, and so many frames wait that the next is lost.
  void fill() {
    full = true;
    while (!node.transmitter().full()) node.transmitter().send(wire_frame("77F#00"));
  }

  /// Compares the frames sent since the last expect(), in their order and without any other.
  /// Notation of wire_frame(); times where the test needs them: "@200000 705#05".
  void expect(std::vector<std::string> frames) {
    std::vector<std::string> actual;
    for (std::size_t i = 0; i < sent.size(); ++i) {
      const bool timed = i < frames.size() && frames[i].starts_with('@');
      actual.push_back(
          (timed ? "@" + std::to_string(sent[i].at.time_since_epoch().count()) + " " : "") +
          wire_text(sent[i].frame));
    }
    EXPECT_EQ(actual, frames);
    sent.clear();
  }

  struct Sent {
    Time at;
    Frame frame;
  };
  std::vector<Sent> sent;
  Time now{};
  bool full = false;  ///< the controller takes no frames
  /// Called while a frame is sent, like a port that delivers the answer at once.
  std::function<void(const Frame&)> on_sent = [](const Frame&) {};

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<WireNode*>(context);
    if (self.full) return false;
    self.sent.push_back({self.now, frame});
    self.on_sent(frame);
    return true;
  }

  DictionaryTables tables_;

 public:
  Node node;
};

}  // namespace canvoy
