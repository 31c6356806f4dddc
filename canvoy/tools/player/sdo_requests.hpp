// Reads and writes objects of other nodes for viewers: one request at a time, from a node without a
// node-ID and without entries.
//
//     SdoRequests desk(world.port(slot));
//     world.occupy(slot, desk.node());
//     desk.read(5, 0x1000, 0, [](const SdoRequests::Answer& answer) { ... });
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::tools {

class SdoRequests {
 public:
  using Bytes = std::vector<std::uint8_t>;
  /// The value that was read (empty for a write), or the error.
  struct Answer {
    SdoEnd end = {};
    Bytes bytes = {};
  };
  using Done = std::function<void(const Answer&)>;

  static constexpr std::size_t waiting_max = 64;
  static constexpr std::size_t value_max = 64 * 1024;

  explicit SdoRequests(const Port& port);
  SdoRequests(const SdoRequests&) = delete;
  SdoRequests& operator=(const SdoRequests&) = delete;

  Node& node() { return node_; }
  /// Uses the time of the node: call node().advance(now) before. `done` is called once; immediately
  /// if too many requests wait.
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
  std::deque<Request> waiting_;  ///< the first one is active
  Bytes read_;
};

}  // namespace canvoy::tools
