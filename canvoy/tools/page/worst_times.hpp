// Time at which each invariant reached its worst value, found by repeated checks, since a referee
// gives the value without its time.
//
//     times.look(now, network.judged());
//     times.add_to(summary["invariants"], network.judged());
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

class WorstTimes {
 public:
  /// To be called repeatedly; the interval gives the accuracy.
  void look(Time now, std::span<const Judged> all);
  void clear() { known_.clear(); }
  /// Adds `worst_at` in seconds and the `words` of the measure to elements in the order of `all`;
  /// none for what was never judged.
  void add_to(nlohmann::ordered_json& invariants, std::span<const Judged> all) const;

 private:
  struct Known {
    const InvariantRow* kind;
    std::uint8_t part;
    std::size_t fault;
    double worst;
    Time at;
  };
  const Known* find(std::size_t place, const Judged& judged) const;

  std::vector<Known> known_;  ///< usually in the order of the invariants
};

}  // namespace canvoy::tools
