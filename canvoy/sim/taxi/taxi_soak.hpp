// The shifts of a soak: a seed decides what the driver does, and which faults come, alone and in
// pairs.
//
//     TaxiNetwork network(soak_taxi(17));
//     network.run_until(Time(taxi_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

inline constexpr Duration taxi_soak_time = 3h;

/// Faults within `time`, some at its start; half of them meet another one.
TaxiOptions soak_taxi(std::uint64_t seed, Duration time = taxi_soak_time);
/// A verdict may be wrong in the other direction as well: the wheels are larger than the meter
/// believes, and that has to be seen.
void enlarge_wheels(TaxiOptions& options);

}  // namespace canvoy::taxi
