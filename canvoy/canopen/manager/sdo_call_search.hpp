// Search for the caller of the SDO manager. The call on 6E0h has no node-ID, so 1F10h of all nodes
// is read until requests are found: first of the nodes heard before, then of the others, which may
// be silent or absent (CiA 302-5).
//
//     SdoCallSearch search;
//     search.call();
//     if (search.is_called()) search.begin();
//     while (NodeId node = search.next(own)) if (ask(node)) break;
#pragma once

#include <bitset>

#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// State of the search; asks no node itself.
class SdoCallSearch {
 public:
  /// Resets everything.
  void reset() { *this = {}; }

  /// Notes that a node is present, or was lost.
  void hear(NodeId node, bool is_there) { heard_[node] = is_there; }
  /// True if a node was heard, and not lost since.
  bool was_heard(NodeId node) const { return heard_[node]; }

  /// Notes a call.
  void call() { is_called_ = true; }
  /// True if a call has not led to a search yet.
  bool is_called() const { return is_called_; }
  /// Begins a search. After a call during a search, nodes heard before are read once more: an
  /// answer may have been lost. The search among the others continues at its position.
  void begin();
  /// Next node to read, except the manager itself; 0: the search is over.
  NodeId next(NodeId manager);
  /// Notes that the node had called. Nodes not heard before are then skipped.
  void find(NodeId node) { has_found_ = heard_[node] = true; }

 private:
  using Nodes = std::bitset<node_id_max + 1>;

  NodeId choose(NodeId manager) const;

  Nodes heard_;
  Nodes to_ask_;  ///< of the present search
  bool is_called_ = false;
  bool is_under_way_ = false;
  bool asks_all_ = false;  ///< the search has reached nodes not heard before
  bool has_found_ = false;
};

}  // namespace canvoy
