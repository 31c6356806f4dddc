// Common parts of the tests of days of a bus.
#pragma once

#include <cstdint>
#include <string>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line {

/// Names of the broken invariants.
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

}  // namespace canvoy::bus_line
