// Which nodes are on a bus: who is heard, and who answers to a question for its device type
// (1000h), while it is listened to.
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

#include "canvoy/canopen/nmt/nmt.hpp"
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

  // An answer counts whenever it comes. They throw Failure where a question does not get onto the
  // bus, and on a signal.

  /// Asks the nodes 1 to 127, each once.
  void ask_all();
  /// Those that are heard and have not answered. False: there are none.
  bool ask_silent();
  /// Asks by LSS whether anybody has no node-ID (CiA 305).
  void ask_unconfigured();

  /// Throws Failure on a signal.
  void listen_until(Time end);

  /// In the order of their node-IDs.
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
