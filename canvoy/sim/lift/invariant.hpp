// What must hold in a building with lifts, whatever happens, and by how much it did.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/sim/invariant.hpp"

namespace canvoy::lift {

enum class InvariantKind : std::uint8_t {
  closed_while_moving,  ///< seconds of movement with a door open or unlocked outside a door zone
  opens_at_floor,       ///< how far from a floor a door began to open; in millimetres
  no_overload,          ///< with what load a car left a floor; in kilograms
  speed,                ///< in m/s
  acceleration,         ///< in m/s2
  jerk,                 ///< in m/s3
  travel,               ///< how far beyond the lowest or highest floor; in metres
  call_acknowledged,    ///< from a button to its lamp, or a car; in seconds
  call_served,      ///< from a lamp to a wide open door, or a reason to take it back; in seconds
  no_call_lost,     ///< calls whose lamp went out without an open door and reason
  no_endless_wait,  ///< the longest that anybody waited; in seconds
  fire_recall,      ///< from the alarm to standing open at the fire floor; in seconds
  fire_doors,       ///< doors that opened at other floors during a recall
  fire_buttons,     ///< doors that opened without their button while the fire brigade drove
  fire_calls,       ///< calls that were taken in a recall, or of landings by the fire brigade
  chain_stops,      ///< moving cars that the safety chain stopped although no fault was there
  levelled,         ///< how far from its floor a car stood with an open door; in millimetres
  safe_stand,       ///< from a fault to a car that stands, or to one that starts; in seconds
  emergency_told,   ///< from a fault to its emergency on the bus; in seconds
  service_resumed,  ///< how long people wanted it after a fault, and nobody was carried; in seconds
  nobody_gives_up,  ///< people who took the stairs, and no fault was there to blame
  no_endless_ride,  ///< the longest that anybody was in a car; in seconds
};

/// All kinds, in the order of InvariantKind.
std::span<const InvariantName> invariant_names();
const InvariantName& invariant_name(InvariantKind kind);

/// `part` is the number of the lift.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::lift
