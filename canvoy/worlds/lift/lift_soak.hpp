// The buildings of a soak: a seed decides lifts, doors, floors, the kind of calls, the traffic, and
// the faults.
//
//     LiftNetwork network(soak_network(17));
//     network.run_until(Time(soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/lift/lift_network_description.hpp"

namespace canvoy::lift {

inline constexpr Duration soak_time = 60min;  ///< length of a run of a soak

/// Draws one fault after the other within `time`.
LiftNetworkDescription soak_network(std::uint64_t seed, Duration time = soak_time);
/// Like soak_network(), with the same building, but each time two faults meet.
LiftNetworkDescription soak_network_of_pairs(std::uint64_t seed, Duration time = soak_time);

}  // namespace canvoy::lift
