// The patrols of a soak: a seed decides what the crew does, and which faults occur, alone and in
// pairs.
//
//     PoliceNetwork network(soak_police(17));
//     network.run_until(Time(police_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/police/police_network.hpp"

namespace canvoy::police {

inline constexpr Duration police_soak_time = 3h;  ///< length of a run of a soak

/// Draws faults within `time`, some at its start; half of them meet another one.
PoliceOptions soak_police(std::uint64_t seed, Duration time = police_soak_time);
/// Adds an error that verdicts must detect, since they may be wrong in the other direction as well:
/// the blue flashers give no light.
void darken(PoliceOptions& options);

}  // namespace canvoy::police
