// Invariants of a building with lifts: what must hold whatever happens, and by what margin it held.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::lift {

/// What must hold in a building with lifts; invariant_rows has name, unit and source of the bound
/// of each.
enum class InvariantKind : std::uint8_t {
  closed_while_moving,
  opens_at_floor,
  no_overload,
  speed,
  acceleration,
  jerk,
  travel,
  call_acknowledged,
  call_served,
  no_call_lost,
  no_endless_wait,
  fire_recall,
  fire_doors,
  fire_buttons,
  fire_calls,
  chain_stops,
  levelled,
  safe_stand,
  emergency_told,
  service_resumed,
  nobody_gives_up,
  no_endless_ride,
  lift_serves,
  nobody_trapped,
  rescued,
  real_position,
  weak_brake,
  inspection_speed,
  inspection_buttons,
  inspection_calls,
  fire_ride,
  shown_floor
};

/// All kinds, in the order of InvariantKind, with the sources of their bounds. Values of a file are
/// within the bounds of the norm: check(description).
inline constexpr InvariantRow invariant_rows[] = {
    {"closed_while_moving", "moved with a door open or unlocked outside a door zone", "s",
     "EN 81-20, 5.3.8.1"},
    {"opens_at_floor", "a door began to open beside a floor by", "mm", "EN 81-20, 5.12.1.1.4"},
    {"no_overload", "left a floor with", "kg", "EN 81-20, 5.12.1.2"},
    {"speed", "fastest", "m/s", "EN 81-20, 5.9.2.4"},
    {"acceleration", "strongest acceleration", "m/s2", "file"},
    {"jerk", "strongest jerk", "m/s3", "file"},
    {"travel", "beyond the last floors by", "m", "file"},
    {"call_acknowledged", "from a button to its lamp", "s", "canvoy"},
    {"call_served", "from a lamp to a car", "s", "canvoy"},
    {"no_call_lost", "calls lost", "", "canvoy"},
    {"no_endless_wait", "longest wait", "s", "canvoy"},
    {"fire_recall", "from a fire alarm to open doors at the fire floor", "s", "canvoy"},
    {"fire_doors", "doors that opened at other floors in a recall", "", "EN 81-73"},
    {"fire_buttons", "doors that opened by themselves under the fire brigade", "", "EN 81-72"},
    {"fire_calls", "calls taken in a fire service", "", "EN 81-73"},
    {"chain_stops", "stops by the safety chain, or between floors, without a fault", "", "canvoy"},
    {"levelled", "stood with an open door beside its floor by", "mm", "EN 81-20, 5.12.1.1.4"},
    {"safe_stand", "from the fault to a car that stands", "s", "canvoy"},
    {"emergency_told", "from the fault to its emergency on the bus", "s", "canvoy"},
    {"service_resumed", "wanted since the end of the fault until a passenger was carried", "s",
     "canvoy"},
    {"nobody_gives_up", "people who gave up without a fault", "", "canvoy"},
    {"no_endless_ride", "longest ride", "s", "canvoy"},
    {"lift_serves", "stood while a person waited longer than it takes to come", "s", "canvoy"},
    {"nobody_trapped", "stood with people behind shut doors", "s", "canvoy"},
    {"rescued", "people were shut in, whatever was broken, until they were let out", "s",
     "EN 81-28"},
    {"real_position", "a real position unit said that the car is elsewhere by", "mm", "canvoy"},
    {"weak_brake", "trips with a brake that holds too little", "", "EN 81-20, 5.6.7.3"},
    {"inspection_speed", "fastest by inspection control", "m/s", "EN 81-20, 5.12.1.5.2.1"},
    {"inspection_buttons", "moved in inspection as no button asked for", "s", "canvoy"},
    {"inspection_calls", "calls taken in inspection", "", "EN 81-20, 5.12.1.5.2.1"},
    {"fire_ride", "the fire brigade in the car waited to be at its floor", "s", "canvoy"},
    {"shown_floor", "a display named another floor than that of its standing car for", "s",
     "canvoy"},
};
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);  ///< number of invariants
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::shown_floor) + 1);
/// Names and limits, for the table of a run.
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// `part` is the number of the lift.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::lift
