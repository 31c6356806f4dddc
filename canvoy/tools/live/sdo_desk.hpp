// Reads and writes objects of other nodes for people who look on: one request after the other, from
// a node without a node-ID that has nothing of its own.
//
//     SdoDesk desk(world.port(slot));
//     world.occupy(slot, desk.node());
//     desk.read(5, 0x1000, 0, [](const SdoDesk::Answer& answer) { ... });
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::tools {

class SdoDesk {
 public:
  using Bytes = std::vector<std::uint8_t>;
  /// The value that was read, none of one that was written; or why not.
  struct Answer {
    SdoEnd end = {};
    Bytes bytes = {};
  };
  using Done = std::function<void(const Answer&)>;

  static constexpr std::size_t waiting_max = 64;
  static constexpr std::size_t value_max = 64 * 1024;

  explicit SdoDesk(const Port& port);
  SdoDesk(const SdoDesk&) = delete;
  SdoDesk& operator=(const SdoDesk&) = delete;

  Node& node() { return node_; }
  /// Time is that of the node: call node().advance(now) before. `done` is called once, at once
  /// where too many wait already.
  void read(NodeId server, std::uint16_t index, std::uint8_t sub, Done done);
  void write(NodeId server, std::uint16_t index, std::uint8_t sub, Bytes value, Done done);

 private:
  struct Request {
    NodeId server = 0;
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    bool writes = false;
    Bytes value;
    Done done;
  };

  void add(Request request);
  void start_next();
  AbortCode start(const Request& request);
  AbortCode take(std::span<const std::uint8_t> bytes);
  void finished(SdoClient::Outcome outcome);

  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 16> backlog_{};
  Node node_;
  SdoClient client_;
  std::deque<Request> waiting_;  ///< the first is under way
  Bytes read_;
};

}  // namespace canvoy::tools
