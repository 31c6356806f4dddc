// Nodes on a bus that are heard but not understood: a late listener has missed what nodes sent at
// their start.
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
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/session/session.hpp"

namespace canvoy::tools {

/// Each bus has its own node with a node-ID.
struct NodeOnBus {
  std::string bus;
  NodeId id = 0;

  friend bool operator==(const NodeOnBus&, const NodeOnBus&) = default;
};

class UnknownNodes {
 public:
  /// Maximum number of buses.
  static constexpr std::size_t buses_max = 256;

  void hear(std::string_view bus, const Frame& frame, const text::FrameWords& words);

  /// Nodes with PDOs that were heard but cannot be decoded at present.
  std::vector<NodeOnBus> unknown() const;
  /// Text on how such a node can become known, for one that was not reported before; empty: none.
  std::string next_untold();
  /// A node that was heard and not requested before.
  std::optional<NodeOnBus> next_unasked();
  /// `nodes 5, 10 are not known: ...`; empty if all are known. Gives the bus if the node-ID exists
  /// on several buses.
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

/// The sender of a frame in the pre-defined connection set: emergencies, PDOs, SDO answers, error
/// control; 0: none (CiA 301, 7.3.3).
NodeId sender_of(const Frame& frame);

/// Reads what is needed to decode a node: device type, identity, PDO parameters and mappings.
/// Listeners on the bus learn from the answers. False if the node does not answer.
bool ask_node(Session& session, NodeId node);

}  // namespace canvoy::tools
