// A tool on a real bus: an SDO client without a node-ID of its own, which reads and writes other
// nodes and waits.
//
//     Session session("can0");
//     std::vector<std::uint8_t> bytes = session.read(5, 0x1000, 0);
#pragma once

#include <functional>
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
#include "canvoy/tools/ask/node_argument.hpp"

namespace canvoy::tools {

/// Who only asks has no entries of its own.
inline constexpr DictionaryTables no_dictionary{};

class Session {
 public:
  static constexpr Duration default_time_out = 1s;

  /// Of several buses with commas between them (`can0,can1`) the first is spoken on, until another
  /// one is chosen; the others are only listened to. Throws Failure where one cannot be opened;
  /// UsageError where an address is none, or `sim`.
  explicit Session(std::string_view bus, Duration time_out = default_time_out);
  ~Session();

  /// Throws Failure with what the node answered, or that it did not.
  std::vector<std::uint8_t> read(NodeId node, std::uint16_t index, std::uint8_t sub);
  /// The same, and the abort code where the node or this side aborts: throws Failure only where it
  /// does not answer.
  Result<std::vector<std::uint8_t>> try_read(NodeId node, std::uint16_t index, std::uint8_t sub);
  void write(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> value);

  /// Of values to come that do not fit into one frame: in segments, unless blocks are chosen.
  void choose(SdoTransfer transfer) { client_->choose(transfer); }
  /// For an answer from now on.
  void set_time_out(Duration time_out) { time_out_ = time_out; }
  /// Nodes to come are those of a network behind `module`, which is told so before each transfer.
  void reach_behind(NodeId module, const RemoteSettings& settings) { behind_ = {module, settings}; }
  /// Nodes to come are on the bus itself.
  void reach_bus() { behind_ = {}; }
  /// In which nodes are reached; 0: the bus itself.
  std::uint16_t network() const { return behind_.module == 0 ? 0 : behind_.settings.network; }
  /// One of buses() is spoken on from now on, as by a new Session. Not while a transfer is under
  /// way.
  void speak_on(const host::HostBus& bus);
  /// Shows on a terminal how far a transfer of many bytes is.
  void show_progress(bool shows = true) { shows_progress_ = shows; }

  /// Puts a frame on the bus, and waits until it is out. Throws Failure where it does not go.
  void send(const Frame& frame);

  /// Each frame from now on, until another one hears; as long as the loop runs.
  void hear(std::function<void(const host::BusFrame&)> hears);
  /// Runs the loop until the time is over, or somebody stops it. Throws Failure where the user
  /// interrupts it.
  void run_for(Duration duration);

  host::EventLoop& loop() { return *loop_; }
  /// The node without a node-ID that asks the others.
  Node& node() { return *node_; }
  host::HostBus& bus() { return *bus_; }
  /// All that are listened to.
  std::vector<host::HostBus*> buses();

 private:
  struct Behind {
    NodeId module = 0;  ///< 0: nodes are on the bus itself
    RemoteSettings settings{};
  };

  void join();
  NodeId server_of(NodeId node);
  void confirmed(const Frame& frame, Time now);
  std::string node_text(NodeId node) const;
  AbortCode start_upload(NodeId node, std::uint16_t index, std::uint8_t sub);
  SdoEnd wait(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started);
  void wait_done(NodeId node, std::uint16_t index, std::uint8_t sub, AbortCode started);
  AbortCode take(std::span<const std::uint8_t> bytes);
  void run();
  void finished(SdoClient::Outcome outcome);

  Duration time_out_;
  std::unique_ptr<host::EventLoop> loop_;
  std::unique_ptr<host::HostBus> bus_;
  std::vector<std::unique_ptr<host::HostBus>> others_;
  std::unique_ptr<host::Attachment> attachment_;
  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 16> backlog_{};
  std::unique_ptr<Node> node_;
  std::unique_ptr<SdoClient> client_;
  std::array<std::uint8_t, SdoBlockClient::buffer_size> block_{};
  std::unique_ptr<SdoBlockClient> blocks_;
  std::function<void(const host::BusFrame&)> hears_;
  bool is_hearing_ = false;
  Behind behind_;
  std::optional<sdo::Message> confirmation_;
  bool shows_progress_ = false;
  SdoEnd end_ = SdoEnd::no_answer();
  std::vector<std::uint8_t> read_;
};

/// A bus, of which a log is none: that can only be listened to. Throws UsageError.
host::BusAddress any_bus(std::string_view text);
/// One that other processes can be on. Throws UsageError where the address is none, or `sim`.
host::BusAddress real_bus(std::string_view text);
/// In bit/s: `said`, in kbit/s, unless that is 0; else that of the interface; 0 where it cannot be
/// known, as of several buses. Throws UsageError as real_bus() does.
unsigned bit_rate_of(std::string_view bus, unsigned said);

}  // namespace canvoy::tools
