// Bounds of EN 81-20 for the design of a lift: a file beyond them would be judged by bounds of its
// own, and could break none of them.
//
//     const std::string error = beyond_norm(building.lift(1));
//     if (!error.empty()) ... // "door_zone_m = 5: EN 81-20, 5.3.8.1, allows 0.35 m"
#pragma once

#include <string>

#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::lift {

/// Greatest distance from a floor at which doors may be unlocked where motors move those of car and
/// landing together (EN 81-20, 5.3.8.1).
inline constexpr double door_zone_most_m = 0.35;
/// Greatest kinetic energy of a door at its mean speed of closing (EN 81-20, 5.3.6.2.2.1).
inline constexpr double door_energy_most_j = 10;
/// Greatest overload, as a share of the rated load, from which on a car must stay; for a small one
/// at least 75 kg (EN 81-20, 5.12.1.2).
inline constexpr double overload_most_share = 0.1;
inline constexpr double overload_most_kg = 75;  ///< least bound of the overload, for small cars
/// Mass of a person, by which the rated load gives the number of persons (EN 81-20, 5.4.2.3.1).
inline constexpr double person_kg = 75;

/// Energy of two leaves that part in the middle, each at half the speed at which the opening gets
/// wider.
constexpr double door_energy_j(double mass_kg, double speed_m_s) {
  const double of_leaf_m_s = speed_m_s / 2;
  return mass_kg * of_leaf_m_s * of_leaf_m_s / 2;
}

/// The first key of a file that is beyond the norm, and the limit of the norm; empty: there is
/// none.
std::string beyond_norm(const LiftDesign& design);

}  // namespace canvoy::lift
