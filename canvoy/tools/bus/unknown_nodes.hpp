// Who is heard on a bus and not understood: a listener who joins late has missed what nodes said of
// themselves when they started.
//
//     UnknownNodes nodes;
//     nodes.hear(bus, frame, words);
//     if (!nodes.unknown().empty()) show(nodes.text());  // how to tell
//     ask_node(session, node);                           // or ask it: whoever listens learns
#pragma once

#include <bitset>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/tools/bus/session.hpp"
#include "canvoy/words/frame_decoder.hpp"

namespace canvoy::tools {

/// Of several buses, each has a node of its own with the same node-ID.
struct NodeOnBus {
  std::string bus;
  NodeId id = 0;

  friend bool operator==(const NodeOnBus&, const NodeOnBus&) = default;
};

class UnknownNodes {
 public:
  /// More are not looked at.
  static constexpr std::size_t buses_max = 256;

  void hear(std::string_view bus, const Frame& frame, const words::FrameWords& words);

  /// Those of which PDOs were heard that nobody can read, as it is now.
  std::vector<NodeOnBus> unknown() const;
  /// How one of them becomes known that was not told before; empty where there is none.
  std::string next_untold();
  /// One of all nodes that were heard and not asked before.
  std::optional<NodeOnBus> next_unasked();
  /// `nodes 5, 10 are not known: ...`; empty where all are. The bus is told where another one has
  /// the node-ID as well.
  std::string text() const;

 private:
  using Nodes = std::bitset<node_id_max + 1>;
  struct Bus {
    Nodes heard;
    Nodes unknown;
    Nodes told;
    Nodes asked;
  };

  bool is_on_several(NodeId id) const;
  std::string option(const NodeOnBus& node) const;
  std::string how_to_know(const NodeOnBus& node) const;

  std::map<std::string, Bus, std::less<>> buses_;
};

/// Whose frame it is, by the pre-defined connection set (CiA 301, 7.3.3): emergencies, PDOs,
/// answers of SDO, error control; 0: nobody's.
NodeId sender_of(const Frame& frame);

/// Reads what says how to understand a node: device type, identity, PDO parameters and mappings.
/// Whoever listens on the bus learns from the answers. False where the node does not answer.
bool ask_node(Session& session, NodeId node);

}  // namespace canvoy::tools
