// The days of a soak: a seed decides who rides, what the traffic is, and which faults come, alone
// and in pairs.
//
//     BusNetwork network(soak_bus(17));
//     network.run_until(Time(bus_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus {

inline constexpr Duration bus_soak_time = 2h;

/// Faults within `time`, some at its start; half of them meet another one.
BusNetworkOptions soak_bus(std::uint64_t seed, Duration time = bus_soak_time);
/// A verdict may be wrong in the other direction as well: a destination indicator does not change,
/// and that has to be seen.
void freeze(BusNetworkOptions& options);

}  // namespace canvoy::bus
