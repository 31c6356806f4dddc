// A tool on a real bus: an SDO client without a node-ID, which reads and writes other nodes and
// waits.
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
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/tools/argument/answer_time.hpp"
#include "canvoy/tools/argument/node_argument.hpp"

namespace canvoy::tools {

/// A client has no entries of its own.
inline constexpr DictionaryTables no_dictionary{};

class Session {
 public:
  /// Opens a bus, or several separated by commas (`can0,can1`): the first one is used for sending
  /// until another is chosen; the others are only listened to. Throws Failure if one cannot be
  /// opened; UsageError if an address is not valid, or `sim`.
  explicit Session(std::string_view bus, AnswerTime time_out = {});
  ~Session();

  /// Throws Failure with the answer of the node, or for a missing answer.
  std::vector<std::uint8_t> read(NodeId node, std::uint16_t index, std::uint8_t sub);
  /// Like read(), but returns the abort code if the node or this side aborts; throws Failure only
  /// if there is no answer.
  Result<std::vector<std::uint8_t>> try_read(NodeId node, std::uint16_t index, std::uint8_t sub);
  void write(NodeId node, std::uint16_t index, std::uint8_t sub,
             std::span<const std::uint8_t> value);

  /// Sets the transfer for values that do not fit into one frame: segments by default, or blocks.
  void choose(SdoTransfer transfer) { client_->choose(transfer); }
  /// Sets the time limit for answers.
  void set_time_out(AnswerTime time_out) { time_out_ = time_out; }
  /// Sets further nodes to be those of a network behind `module`, which is indicated before each
  /// transfer.
  void reach_behind(NodeId module, const RemoteSettings& settings) { behind_ = {module, settings}; }
  /// Sets further nodes to be on the bus itself.
  void reach_bus() { behind_ = {}; }
  /// Network of the nodes; 0: the bus itself.
  std::uint16_t network() const { return behind_.module == 0 ? 0 : behind_.settings.network; }
  /// Sends on one of buses() from now on, as a new Session would. Not during a transfer.
  void speak_on(const host::HostBus& bus);
  /// Shows the progress of long transfers on a terminal.
  void show_progress(bool shows = true) { shows_progress_ = shows; }

  /// Sends a frame, and waits until it is out. Throws Failure if it cannot be sent.
  void send(const Frame& frame);

  /// Sets the receiver of all frames, while the loop runs; replaces the previous one.
  void hear(std::function<void(const host::BusFrame&)> hears);
  /// Runs the loop for this time, or until it is stopped. Throws Failure if the user interrupts it.
  void run_for(Duration duration);

  /// Why a bus cannot be reached at present, as its carrier says; empty: none is lost. Of a bus
  /// without states, as UDP, it stays until a node answers.
  const std::string& loss() const { return loss_; }
  /// Whether a bus was lost at any time, if it has come back or not.
  bool was_lost() const { return was_lost_; }

  host::EventLoop& loop() { return *loop_; }
  /// The node without a node-ID that sends the requests.
  Node& node() { return *node_; }
  host::HostBus& bus() { return *bus_; }
  /// All buses that are listened to.
  std::vector<host::HostBus*> buses();

 private:
  struct Behind {
    NodeId module = 0;  ///< 0: the bus itself
    RemoteSettings settings{};
  };

  void follow(host::HostBus& bus);
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

  AnswerTime time_out_;
  Duration limit_;  ///< for the answers of this transfer
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
  std::string loss_;
  bool was_lost_ = false;
};

/// Reads the address of a bus, not of a log, which can only be listened to. Throws UsageError.
host::BusAddress any_bus(std::string_view text);
/// Reads the address of a bus that other processes can use. Throws UsageError if it is not valid,
/// or `sim`.
host::BusAddress real_bus(std::string_view text);
/// Bit rate in bit/s: `said`, in kbit/s, unless it is 0; else that of the interface; 0 if unknown,
/// as for several buses. Throws UsageError like real_bus().
unsigned bit_rate_of(std::string_view bus, unsigned said);

}  // namespace canvoy::tools
