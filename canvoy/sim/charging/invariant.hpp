// What must hold in the network of a battery and its charger, whatever happens, and by how much it
// did.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::charging {

enum class InvariantKind : std::uint8_t {
  ampere_hours,  ///< as the charger counts them, against those that went in; in percent
  energy,        ///< the same for the energy; in percent
  current_outside_handshake,  ///< the longest time that it flowed without agreement; in seconds
  current_before_ready,       ///< how often it began before the charger said that it is ready
  battery_left_waiting,  ///< the longest time that it asked for current, nothing was wrong, and
                         ///< none flowed; in seconds
  fault_seen,            ///< from a fault's start to the charger's answer; in seconds
};

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::charging
