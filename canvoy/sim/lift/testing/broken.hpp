// What must hold in a building and did not, so that a test that fails says it. For tests only.
#pragma once

#include <string>

#include "canvoy/sim/lift/lift_network.hpp"

namespace canvoy::lift {

/// A line for each invariant that was broken; nothing where all hold.
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
