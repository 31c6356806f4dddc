// Actions of viewers on the nodes of a network: SDO reads and writes, and NMT commands. Used for
// worlds and real buses.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/page/live_source.hpp"
#include "canvoy/tools/page/recorder.hpp"
#include "canvoy/tools/page/write_permission.hpp"

namespace canvoy::tools {

// Reads and writes objects of other nodes for viewers: one request at a time, from a node without a
// node-ID and without entries.
//
//     SdoRequests desk(world.port(slot));
//     world.occupy(slot, desk.node());
//     desk.read(5, 0x1000, 0, [](const SdoRequests::Answer& answer) { ... });

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

/// A frame or a request for a bus.
struct BusRequest {
  enum class Kind : std::uint8_t { read, write, nmt } kind = Kind::read;
  std::string bus;
  NodeId node = 0;  ///< for NMT, 0: all nodes
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  SdoRequests::Bytes bytes{};  ///< the value to write, or the command
};

class LiveNetwork : public LiveSource {
 public:
  LiveNetwork(const FramePrinterOptions& options, WritePermission permission)
      : LiveSource(options), permission_(std::move(permission)) {}

  void act(std::string_view what, const Json& arguments, const Done& done) override;
  /// Like Recorder::allow().
  void allow_recording(const std::string& folder) { recorder_.allow(folder); }

 protected:
  /// Sends the request on its bus. `done` may be empty. Throws Failure if this is not possible.
  virtual void request(const BusRequest& request, const SdoRequests::Done& done) = 0;
  const WritePermission& permission() const { return permission_; }
  Recorder& recorder() { return recorder_; }
  /// Wall clock at Time{}, for logs; 0 for the time of a run.
  virtual Duration epoch() const { return Duration::zero(); }

 private:
  ObjectAddress address_of(std::string_view bus, NodeId node, std::string_view text);
  void read(const Json& arguments, const Done& done);
  void write(const Json& arguments, const Done& done);
  void command(const Json& arguments, const Done& done);

  WritePermission permission_;
  Recorder recorder_;
};

/// A text member of a request that was checked.
std::string text_of(const nlohmann::ordered_json& arguments, const char* name);

}  // namespace canvoy::tools
