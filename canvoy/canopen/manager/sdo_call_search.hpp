// Who called the SDO manager? The call on 6E0h names nobody (CiA 302-5), so that 1F10h of all nodes
// is read until requests are found: of those that were heard first, then of the others, which may
// be silent, or absent.
//
//     SdoCallSearch search;
//     search.call();
//     if (search.is_called()) search.begin();
//     while (NodeId node = search.next(own)) if (ask(node)) break;
#pragma once

#include <bitset>

#include "canvoy/canopen/cob_id.hpp"

namespace canvoy {

class SdoCallSearch {
 public:
  /// All is forgotten.
  void reset() { *this = {}; }

  /// A node is there, or was lost.
  void hear(NodeId node, bool is_there) { heard_[node] = is_there; }
  bool was_heard(NodeId node) const { return heard_[node]; }

  /// Somebody called.
  void call() { is_called_ = true; }
  /// And no search for it has begun.
  bool is_called() const { return is_called_; }
  /// A call in the middle of a search has those that were heard asked once more: an answer may have
  /// been lost. The search among the others goes on where it is.
  void begin();
  /// Whom to ask next, but the manager itself; 0: the search is over.
  NodeId next(NodeId manager);
  /// The node had called. Those that were not heard are left out then.
  void find(NodeId node) { has_found_ = heard_[node] = true; }

 private:
  using Nodes = std::bitset<node_id_max + 1>;

  NodeId choose(NodeId manager) const;

  Nodes heard_;
  Nodes to_ask_;  ///< of the present search
  bool is_called_ = false;
  bool is_under_way_ = false;
  bool asks_all_ = false;  ///< the search has come to nodes that were not heard
  bool has_found_ = false;
};

}  // namespace canvoy
