#include "canvoy/sim/lift/invariant.hpp"

#include <array>

namespace canvoy::lift {

namespace {

constexpr auto invariants = std::to_array<InvariantName>({
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
});
static_assert(invariants.size() == static_cast<std::size_t>(InvariantKind::no_endless_ride) + 1);

}  // namespace

std::span<const InvariantName> invariant_names() {
  return invariants;
}

const InvariantName& invariant_name(InvariantKind kind) {
  return invariants.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::lift
