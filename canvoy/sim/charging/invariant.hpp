// What must hold in the network of a battery and its charger, whatever happens, and by how much it
// did.
#pragma once

#include <cstddef>
#include <cstdint>

namespace canvoy {

enum class InvariantKind : std::uint8_t {
  ampere_hours,  ///< as the charger counts them, against those that went in; in percent
  energy,        ///< the same for the energy; in percent
  current_outside_handshake,  ///< the longest time that it flowed without agreement; in seconds
  current_before_ready,       ///< how often it began before the charger said that it is ready
  battery_left_waiting,  ///< the longest time that it asked for current, nothing was wrong, and
                         ///< none flowed; in seconds
  fault_seen,            ///< from a fault's start to the charger's answer; in seconds
};

struct Invariant {
  InvariantKind kind = InvariantKind::ampere_hours;
  std::size_t fault = 0;  ///< fault_seen: its place in the plan
  double value = 0;
  double bound = 0;
  bool held = true;
  /// False: nothing can be said. The fault was over, or the run was, before the time that is
  /// promised had passed.
  bool decided = true;
};

}  // namespace canvoy
