// What tests of days of a bus have in common.
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus {

/// The names of those that are broken.
inline std::string broken(const BusNetwork& network) {
  std::string names;
  for (const Invariant& invariant : network.invariants()) {
    if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
  }
  return names;
}

inline BusNetworkOptions with_seed(std::uint64_t seed) {
  BusNetworkOptions options;
  options.faults.seed = seed;
  return options;
}

}  // namespace canvoy::bus
