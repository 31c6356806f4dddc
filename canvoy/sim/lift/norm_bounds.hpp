// What EN 81-20 leaves to whoever designs a lift: a file that goes beyond it would be judged by
// bounds of its own, and could break none of them.
//
//     const std::string error = beyond_norm(building.lift(1));
//     if (!error.empty()) ... // "door_zone_m = 5: EN 81-20, 5.3.8.1, allows 0.35 m"
#pragma once

#include <string>

#include "canvoy/sim/lift/building.hpp"

namespace canvoy::lift {

/// EN 81-20, 5.3.8.1: how far from a floor doors may be unlocked where motors move those of car and
/// landing together.
inline constexpr double door_zone_most_m = 0.35;
/// EN 81-20, 5.3.6.2.2.1: kinetic energy of a door at its mean speed of closing.
inline constexpr double door_energy_most_j = 10;
/// EN 81-20, 5.12.1.2: from so much above its rated load a car stays; of a small one from 75 kg.
inline constexpr double overload_most_share = 0.1;
inline constexpr double overload_most_kg = 75;

/// Of two leaves that part in the middle, each at half the speed at which the way gets wider.
constexpr double door_energy_j(double mass_kg, double speed_m_s) {
  const double of_leaf_m_s = speed_m_s / 2;
  return mass_kg * of_leaf_m_s * of_leaf_m_s / 2;
}

/// The first key of a file that is beyond the norm, and what that allows; empty: none is.
std::string beyond_norm(const LiftDesign& design);

}  // namespace canvoy::lift
