// Who is heard on a bus and not understood: a listener who joins late has missed what nodes said of
// themselves when they started.
//
//     UnknownNodes nodes;
//     nodes.hear(frame, words);
//     if (!nodes.unknown().empty()) show(nodes.text());  // how to tell
//     ask_node(session, node);                           // or ask it: whoever listens learns
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/words/frame_decoder.hpp"

namespace canvoy::tools {

class UnknownNodes {
 public:
  void hear(const Frame& frame, const words::FrameWords& words);

  /// Those of which PDOs were heard that nobody can read, as it is now.
  std::vector<NodeId> unknown() const;
  /// One of them that was not told before.
  std::optional<NodeId> next_untold();
  /// One of all nodes that were heard and not asked before.
  std::optional<NodeId> next_unasked();
  std::size_t heard() const { return heard_.count(); }
  /// `nodes 5, 10 are not known: ...`; empty where all are.
  std::string text() const;

 private:
  using Nodes = std::bitset<node_id_max + 1>;
  Nodes heard_;
  Nodes unknown_;
  Nodes told_;
  Nodes asked_;
};

/// Whose frame it is, by the pre-defined connection set (CiA 301, 7.3.3): emergencies, PDOs,
/// answers of SDO, error control; 0: nobody's.
NodeId sender_of(const Frame& frame);

/// How a node becomes known.
std::string unknown_node_text(NodeId node);

/// Reads what says how to understand a node: device type, identity, PDO parameters and mappings.
/// Whoever listens on the bus learns from the answers. False where the node does not answer.
bool ask_node(Session& session, NodeId node);

}  // namespace canvoy::tools
