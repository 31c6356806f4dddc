// Common parts of the tests of an excavator: which invariants are broken, and until when its
// machine moves.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "canvoy/worlds/excavator/excavator_network.hpp"

namespace canvoy::excavator {

inline std::vector<std::string_view> broken(const ExcavatorNetwork& network) {
  std::vector<std::string_view> names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names.push_back(invariant_name(invariant.kind).name);
  }
  return names;
}
using Names = std::vector<std::string_view>;

inline const Invariant& find(const std::vector<Invariant>& all, InvariantKind kind) {
  return *std::ranges::find(all, kind, &Invariant::kind);
}

inline ExcavatorOptions with_faults(std::vector<ScheduledFault> faults) {
  ExcavatorOptions options;
  options.length = 30min;
  options.faults.faults = std::move(faults);
  return options;
}

/// Runs until a hand commands this movement, and the machine moves as well.
inline void run_until_moving(ExcavatorNetwork& network, Movement movement) {
  const auto moves = [&] {
    return std::abs(network.machine().speed(movement)) > 0.3 &&
           std::abs(network.panel().wanted(movement)) > 0.3;
  };
  while (!moves() && network.now() < Time(10min)) network.run_until(network.now() + 20ms);
}

/// Time for which the movement continues, up to `most`.
inline Duration time_to_rest(ExcavatorNetwork& network, Duration most = 5s) {
  const auto is_moving = [&] {
    for (std::size_t i = 0; i < movements; ++i) {
      if (network.machine().speed(static_cast<Movement>(i)) != 0) return true;
    }
    return false;
  };
  const Time begun = network.now();
  while (is_moving() && network.now() < begun + most) network.run_until(network.now() + 20ms);
  return network.now() - begun;
}

}  // namespace canvoy::excavator
