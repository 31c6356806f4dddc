// Counts the faults that keep nodes without power: several may affect one node, which has power
// again when the last one is over.
//
//     PowerCuts cuts(Callback<void(NodeId, bool)>::to<&Faults::power>(faults));
//     cuts.set_power(5, false);    // power(5, false), if it had power
//     cuts.set_power(5, true);     // power(5, true), if nobody else keeps it from it
#pragma once

#include <array>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

class PowerCuts {
 public:
  /// Called when a node loses its power or has it again.
  using Switch = Callback<void(NodeId, bool is_on)>;

  /// Makes a count for each number of 8 bits, a node-ID or a world's own, all with power.
  explicit PowerCuts(Switch power) : power_(power) {}

  /// A fault begins with false, and ends with true.
  void set_power(NodeId id, bool is_on) {
    const bool changes = is_on ? --cuts_.at(id) == 0 : ++cuts_.at(id) == 1;
    if (changes) power_(id, is_on);
  }
  /// Switches power off and on again at once; does nothing to a node without power.
  void restart(NodeId id) {
    if (is_cut(id)) return;
    power_(id, false);
    power_(id, true);
  }
  /// True while a fault keeps the node without power.
  bool is_cut(NodeId id) const { return cuts_.at(id) != 0; }

 private:
  Switch power_;
  std::array<unsigned, 256> cuts_{};
};

}  // namespace canvoy
