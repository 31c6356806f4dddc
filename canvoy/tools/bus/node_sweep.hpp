// Which nodes are on a bus: who is heard, and who answers to a question for its device type
// (1000h), several at a time.
//
//     NodeSweep sweep(session);
//     sweep.listen(1s);
//     sweep.ask_all(100ms);
//     for (const NodeSweep::Found& node : sweep.found()) show(node.id);
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/nmt/nmt.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/tools/bus/session.hpp"

namespace canvoy::tools {

class NodeSweep {
 public:
  struct Found {
    NodeId id = 0;
    bool is_heard = false;               ///< it sends of its own accord
    bool answers = false;                ///< to SDO; an abort code is an answer as well
    std::optional<NmtState> state = {};  ///< as its heartbeat tells
    std::optional<std::uint32_t> device_type = {};
  };

  /// It listens to the bus of the session as long as that lives, and has to live as long.
  explicit NodeSweep(Session& session);
  NodeSweep(const NodeSweep&) = delete;
  NodeSweep& operator=(const NodeSweep&) = delete;

  /// Throws Failure on a signal, as ask_all() does.
  void listen(Duration duration);
  /// Asks the nodes 1 to 127, each once; who does not answer within `time_out` does not answer.
  void ask_all(Duration time_out);

  /// In the order of their node-IDs.
  std::vector<Found> found() const;

 private:
  /// The node of a session has routes for one more.
  static constexpr std::size_t requests_max = 3;

  /// One question under way.
  class Request {
   public:
    Request(NodeSweep& sweep, Node& node) : sweep_(sweep), client_(node) {}
    bool idle() const { return server_ == 0; }
    bool ask(NodeId server, Duration time_out);

   private:
    void answered(SdoClient::Outcome outcome);

    NodeSweep& sweep_;
    SdoClient client_;
    NodeId server_ = 0;
    std::array<std::uint8_t, 4> bytes_{};
  };

  void hear(const Frame& frame);
  void run_for(Duration duration);

  Session& session_;
  std::array<Found, node_id_max + 1> nodes_{};
  std::vector<std::unique_ptr<Request>> requests_;
};

}  // namespace canvoy::tools
