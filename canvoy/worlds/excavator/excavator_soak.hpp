// The shifts of a soak: a seed decides what the operator does, and which faults occur, alone and in
// pairs.
//
//     ExcavatorNetwork network(soak_excavator(17));
//     network.run_until(Time(excavator_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/excavator/excavator_network.hpp"

namespace canvoy::excavator {

inline constexpr Duration excavator_soak_time = 1h;  ///< length of a run of a soak

/// Draws faults within `time`, some at its start; half of them meet another one.
ExcavatorOptions soak_excavator(std::uint64_t seed, Duration time = excavator_soak_time);
/// Adds an error that verdicts must detect, since they may be wrong in the other direction as well:
/// the lamp of the work light gives no light.
void darken(ExcavatorOptions& options);

}  // namespace canvoy::excavator
