// What must hold in a building with lifts, whatever happens, and by how much it did.
#pragma once

#include "canvoy/sim/invariant.hpp"

namespace canvoy::lift {

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
  no_endless_ride
};

/// All kinds, in the order of InvariantKind.
inline constexpr InvariantRow invariant_rows[] = {
    {"closed_while_moving", "moved with a door open or unlocked outside a door zone", "s"},
    {"opens_at_floor", "a door began to open beside a floor by", "mm"},
    {"no_overload", "left a floor with", "kg"},
    {"speed", "fastest", "m/s"},
    {"acceleration", "strongest acceleration", "m/s2"},
    {"jerk", "strongest jerk", "m/s3"},
    {"travel", "beyond the last floors by", "m"},
    {"call_acknowledged", "from a button to its lamp", "s"},
    {"call_served", "from a lamp to a car", "s"},
    {"no_call_lost", "calls lost", ""},
    {"no_endless_wait", "longest wait", "s"},
    {"fire_recall", "from a fire alarm to open doors at the fire floor", "s"},
    {"fire_doors", "doors that opened at other floors in a recall", ""},
    {"fire_buttons", "doors that opened by themselves under the fire brigade", ""},
    {"fire_calls", "calls taken in a fire service", ""},
    {"chain_stops", "moving cars that the safety chain stopped without a fault", ""},
    {"levelled", "stood with an open door beside its floor by", "mm"},
    {"safe_stand", "from the fault to a car that stands", "s"},
    {"emergency_told", "from the fault to its emergency on the bus", "s"},
    {"service_resumed", "wanted since the end of the fault until somebody was carried", "s"},
    {"nobody_gives_up", "people who gave up without a fault", ""},
    {"no_endless_ride", "longest ride", "s"},
};
inline constexpr std::size_t invariant_kinds = std::size(invariant_rows);
static_assert(invariant_kinds == static_cast<std::size_t>(InvariantKind::no_endless_ride) + 1);
constexpr std::span<const InvariantRow> rows_of(InvariantKind) {
  return invariant_rows;
}

/// `part` is the number of the lift.
using Invariant = canvoy::Invariant<InvariantKind>;

}  // namespace canvoy::lift
