// Text of the broken invariants of a building, for messages of failing tests. For tests only.
#pragma once

#include <string>

#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::lift {

/// A line for each broken invariant; empty where all hold.
inline std::string broken(const LiftNetwork& network) {
  std::string text;
  for (const Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    text += "invariant " + std::to_string(static_cast<int>(invariant.kind)) + " of lift " +
            std::to_string(invariant.part) + ": " + std::to_string(invariant.worst) +
            " where no more than " + std::to_string(invariant.allowed) + " may be\n";
  }
  return text;
}

}  // namespace canvoy::lift
