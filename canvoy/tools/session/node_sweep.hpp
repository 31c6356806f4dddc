// Finds the nodes on a bus: those that are heard, and those that answer a request for the device
// type (1000h).
//
//     NodeSweep sweep(session);
//     sweep.ask_all();
//     sweep.listen_until(begin + 1s);
//     for (const NodeSweep::Found& node : sweep.found()) show(node.id);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

class NodeSweep {
 public:
  struct Found {
    NodeId id = 0;
    bool is_heard = false;               ///< sends without request
    bool answers = false;                ///< answers SDO; an abort is an answer as well
    std::optional<NmtState> state = {};  ///< from its heartbeat
    std::optional<std::uint32_t> device_type = {};
  };

  /// Listens to the bus of the session. Must live as long as the session.
  explicit NodeSweep(Session& session);
  NodeSweep(const NodeSweep&) = delete;
  NodeSweep& operator=(const NodeSweep&) = delete;

  // Late answers count. The functions throw Failure if a request cannot be sent, and on a signal.

  /// Requests the nodes 1 to 127, once each.
  void ask_all();
  /// Requests nodes that are heard and have not answered. False: none.
  bool ask_silent();
  /// Asks by LSS whether a node has no node-ID (CiA 305).
  void ask_unconfigured();

  /// Throws Failure on a signal.
  void listen_until(Time end);

  /// Nodes in order of node-ID.
  std::vector<Found> found() const;
  bool has_unconfigured() const { return has_unconfigured_; }

 private:
  void ask(NodeId node);
  void hear(const Frame& frame);
  void take_answer(Found& found, const Frame& frame);

  Session& session_;
  std::array<Found, node_id_max + 1> nodes_{};
  bool has_unconfigured_ = false;
};

}  // namespace canvoy::tools
