// The shifts of a soak: a seed decides what the driver does, and which faults occur, alone and in
// pairs.
//
//     TaxiNetwork network(soak_taxi(17));
//     network.run_until(Time(taxi_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi {

inline constexpr Duration taxi_soak_time = 3h;  ///< length of a run of a soak

/// Draws faults within `time`, some at its start; half of them meet another one.
TaxiOptions soak_taxi(std::uint64_t seed, Duration time = taxi_soak_time);
/// Adds an error that verdicts must detect, since they may be wrong in the other direction as well:
/// the wheels are larger than the meter's constant says.
void enlarge_wheels(TaxiOptions& options);

}  // namespace canvoy::taxi
