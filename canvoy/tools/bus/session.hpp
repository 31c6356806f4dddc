// A tool on a real bus: an SDO client without a node-ID of its own, which reads and writes other
// nodes and waits.
//
//     Session session("can0");
//     std::vector<std::uint8_t> bytes = session.read(5, 0x1000, 0);
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/host/host_bus.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::tools {

/// Who only asks has no entries of its own.
inline constexpr DictionaryTables no_dictionary{};

class Session {
 public:
  static constexpr Duration default_time_out = 1s;

  /// Throws Failure where the bus cannot be opened; UsageError where the address is none, or `sim`.
  explicit Session(std::string_view bus, Duration time_out = default_time_out);
  ~Session();

  /// Throws Failure with what the node answered, or that it did not.
  std::vector<std::uint8_t> read(NodeId node, std::uint16_t index, std::uint8_t sub);
  /// The same, and the node's own abort code where it answers one: throws Failure only where it
  /// does not answer.
  Result<std::vector<std::uint8_t>> try_read(NodeId node, std::uint16_t index, std::uint8_t sub);
  void write(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> value);

  /// Of values to come that do not fit into one frame: in segments, unless blocks are chosen.
  void choose(SdoTransfer transfer) { client_->choose(transfer); }
  /// Nodes to come are those of a network behind `module`, which is told so before each transfer.
  void reach_behind(NodeId module, const RemoteSettings& settings) { behind_ = {module, settings}; }
  /// Shows on a terminal how far a transfer of many bytes is.
  void show_progress() { shows_progress_ = true; }

  /// Puts a frame on the bus, and waits until it is out. Throws Failure where it does not go.
  void send(const Frame& frame);

  host::EventLoop& loop() { return *loop_; }
  /// The node without a node-ID that asks the others.
  Node& node() { return *node_; }
  host::HostBus& bus() { return *bus_; }

 private:
  struct Behind {
    NodeId module = 0;  ///< 0: nodes are on the bus itself
    RemoteSettings settings{};
  };

  NodeId server_of(NodeId node);
  void confirmed(const Frame& frame, Time now);
  std::string node_text(NodeId node) const;
  AbortCode start_upload(NodeId node, std::uint16_t index, std::uint8_t sub);
  AbortCode wait(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started);
  void wait_done(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started);
  AbortCode take(std::span<const std::uint8_t> bytes);
  void run();
  void finished(SdoClient::Outcome outcome);

  Duration time_out_;
  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::unique_ptr<host::Attachment> attachment_;
  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 16> backlog_{};
  std::unique_ptr<Node> node_;
  std::unique_ptr<SdoClient> client_;
  std::array<std::uint8_t, SdoBlockClient::buffer_size> block_{};
  std::unique_ptr<SdoBlockClient> blocks_;
  Behind behind_;
  std::optional<sdo::Message> confirmation_;
  bool shows_progress_ = false;
  SdoClient::Outcome outcome_{AbortCode::time_out};
  std::vector<std::uint8_t> read_;
};

/// A bus that other processes can be on. Throws UsageError where the address is none, or `sim`.
host::BusAddress real_bus(std::string_view text);

/// A node-ID as `10` or `0x0A`. Throws UsageError where it is none.
NodeId parse_node_id(std::string_view text);

}  // namespace canvoy::tools
