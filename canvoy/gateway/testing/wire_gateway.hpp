// A gateway between lines and frames for tests: lines in, frames out, frames in, lines out, at
// exact virtual times.
//
//     WireGateway gateway;
//     gateway.say("[1] 5 r 0x1017 0 u16");
//     gateway.expect_frames({"605#40 17 10 00 00 00 00 00"});
//     gateway.receive("585#4B 17 10 00 F4 01 00 00");
//     gateway.expect_lines({"[1] 500"});
#pragma once

#include <bitset>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/gateway/gateway.hpp"

namespace canvoy::gateway {

/// Takes the lines that a session has for its client, without their ends; checks that each has one.
inline std::vector<std::string> take_lines(Session& session) {
  std::vector<std::string> lines;
  std::string_view output = session.output();
  while (!output.empty()) {
    const std::size_t end = output.find("\r\n");
    if (end == std::string_view::npos) {
      ADD_FAILURE() << "a line has no end: " << output;
      break;
    }
    lines.emplace_back(output.substr(0, end));
    output.remove_prefix(end + 2);
  }
  session.consume(session.output().size());
  return lines;
}

/// A network of which the test is the bus.
class WireNetwork {
 public:
  explicit WireNetwork(Time& clock, std::uint16_t number = 1, NetworkSettings settings = {})
      : network(number, {this, &WireNetwork::take, &WireNetwork::accept}, std::move(settings)),
        now_(clock) {
    network.start(now_);
  }

  void receive(std::string_view text) {
    const Frame frame = wire_frame(text);
    const bool wanted = !filtering_ || frame.is_extended() || wanted_[frame.id];
    if (wanted) network.receive(frame, now_);
    settle();
  }
  void settle() {
    for (int i = 0; network.deadline() <= now_; ++i) {
      ASSERT_LT(i, 10'000) << "the network wants to be called again and again";
      network.advance(now_);
    }
  }
  /// Compares the frames sent since the last call, in the form of the wire language; with times if
  /// the test gives them.
  void expect_frames(const std::vector<std::string>& frames) {
    std::vector<std::string> actual;
    for (std::size_t i = 0; i < sent_.size(); ++i) {
      const bool timed = i < frames.size() && frames[i].starts_with('@');
      actual.push_back((timed ? sent_[i].first : "") + sent_[i].second);
    }
    EXPECT_EQ(actual, frames);
    sent_.clear();
  }
  void forget_frames() { sent_.clear(); }

 private:
  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<WireNetwork*>(context);
    if (self.full) return false;
    self.sent_.emplace_back("@" + std::to_string(self.now_.time_since_epoch().count()) + " ",
                            wire_text(frame));
    if (self.on_sent) self.on_sent(frame);
    return true;
  }
  /// Opens the acceptance filter for an identifier. From the first call on, the filter is closed
  /// for all others.
  static void accept(void* context, std::uint16_t id, bool wanted) {
    auto& self = *static_cast<WireNetwork*>(context);
    self.filtering_ = true;
    self.wanted_[id] = wanted;
  }

  std::bitset<Frame::id_max + 1> wanted_;
  bool filtering_ = false;

 public:
  bool full = false;  ///< the controller takes no frames
  /// Called while a frame is sent, like a bus that delivers the answer at once.
  std::function<void(const Frame&)> on_sent;
  Network network;

 private:
  Time& now_;
  std::vector<std::pair<std::string, std::string>> sent_;
};

/// A gateway with one client and one network, number 1, unless the test adds others.
class WireGateway {
 public:
  explicit WireGateway(NetworkSettings network_settings = {}, const SessionSettings& settings = {})
      : wire(now, 1, std::move(network_settings)), gateway(settings), client(gateway.open()) {
    gateway.add(wire.network);
    wire.forget_frames();
  }

  void say(std::string_view line) { say(client, line); }
  void say(Session& session, std::string_view line) {
    session.receive(std::string(line) + "\r\n");
    settle();
  }
  void receive(std::string_view frame) { wire.receive(frame); }
  void expect_frames(const std::vector<std::string>& frames) { wire.expect_frames(frames); }
  void expect_lines(const std::vector<std::string>& lines) { expect_lines(client, lines); }
  void expect_lines(Session& session, const std::vector<std::string>& lines) {
    EXPECT_EQ(take_lines(session), lines);
    settle();
  }
  /// Sends one line and returns its answer, which must come at once.
  std::string ask(std::string_view line) {
    say(line);
    const std::vector<std::string> lines = take_lines(client);
    settle();
    if (lines.size() != 1) {
      ADD_FAILURE() << lines.size() << " answers to " << line;
      return "";
    }
    return lines.front();
  }

  void run_until(Time until) {
    while (deadline() <= until) {
      now = std::max(now, deadline());
      settle();
    }
    now = until;
  }
  void run_for(Duration duration) { run_until(now + duration); }

  Time now{};
  WireNetwork wire;
  Gateway gateway;
  Session& client;

 private:
  Time deadline() const { return std::min(wire.network.deadline(), gateway.deadline()); }
  void settle() {
    gateway.settle(now);
    wire.settle();
  }
};

}  // namespace canvoy::gateway
