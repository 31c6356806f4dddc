// Who has no power by a fault: several may keep a node from it, and it has it again when the last
// one is over.
//
//     PowerCuts cuts;
//     if (cuts.cut(5)) node.power(false);    // it had power
//     if (cuts.mend(5)) node.power(true);
#pragma once

#include <array>

#include "canvoy/canopen/cob_id.hpp"

namespace canvoy {

class PowerCuts {
 public:
  /// True: it loses its power now.
  bool cut(NodeId id) { return ++cuts_.at(id) == 1; }
  /// True: it has it again.
  bool mend(NodeId id) { return --cuts_.at(id) == 0; }
  bool is_cut(NodeId id) const { return cuts_.at(id) != 0; }

 private:
  std::array<unsigned, node_id_max + 1> cuts_{};
};

}  // namespace canvoy
