// The buildings of a soak: a seed decides lifts, doors, floors, how people call, who comes, and
// what goes wrong.
//
//     LiftNetwork network(soak_network(17));
//     network.run_until(Time(soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/sim/lift/lift_network_description.hpp"

namespace canvoy::lift {

inline constexpr Duration soak_time = 60min;

/// One fault after the other within `time`.
LiftNetworkDescription soak_network(std::uint64_t seed, Duration time = soak_time);
/// The same building, where two faults meet each time.
LiftNetworkDescription soak_network_of_pairs(std::uint64_t seed, Duration time = soak_time);

}  // namespace canvoy::lift
