// The patrols of a soak: a seed decides what the crew does, and which faults come, alone and in
// pairs.
//
//     PoliceNetwork network(soak_police(17));
//     network.run_until(Time(police_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/sim/police/police_network.hpp"

namespace canvoy::police {

inline constexpr Duration police_soak_time = 3h;

/// Faults within `time`, some at its start; half of them meet another one.
PoliceOptions soak_police(std::uint64_t seed, Duration time = police_soak_time);
/// A verdict may be wrong in the other direction as well: the blue flashers give no light, and that
/// has to be seen.
void darken(PoliceOptions& options);

}  // namespace canvoy::police
