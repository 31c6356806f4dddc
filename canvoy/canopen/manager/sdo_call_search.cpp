#include "canvoy/canopen/manager/sdo_call_search.hpp"

namespace canvoy {

void SdoCallSearch::begin() {
  is_called_ = has_found_ = false;
  if (!is_under_way_) to_ask_.reset();
  if (!is_under_way_) asks_all_ = false;
  is_under_way_ = true;
  to_ask_ |= heard_;
}

NodeId SdoCallSearch::next(NodeId manager) {
  while (is_under_way_) {
    if (const NodeId node = choose(manager); node != 0) {
      to_ask_[node] = false;
      return node;
    }
    is_under_way_ = !asks_all_ && !has_found_;
    asks_all_ = true;
    to_ask_ = ~heard_;
  }
  return 0;
}

/// Nodes that were not heard take time.
NodeId SdoCallSearch::choose(NodeId manager) const {
  for (const bool heard : {true, false}) {
    for (NodeId id = node_id_min; id <= node_id_max; ++id) {
      if (to_ask_[id] && heard_[id] == heard && id != manager) return id;
    }
    if (has_found_) break;
  }
  return 0;
}

}  // namespace canvoy
