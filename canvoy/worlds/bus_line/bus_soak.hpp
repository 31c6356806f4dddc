// The days of a soak: a seed decides which riders come, what the traffic is, and which faults
// occur, alone and in pairs.
//
//     BusNetwork network(soak_bus(17));
//     network.run_until(Time(bus_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line {

inline constexpr Duration bus_soak_time = 2h;  ///< length of a run of a soak

/// Draws faults within `time`, some at its start; half of them meet another one.
BusNetworkOptions soak_bus(std::uint64_t seed, Duration time = bus_soak_time);
/// Adds an error that verdicts must detect, since they may be wrong in the other direction as well:
/// a destination indicator does not change.
void freeze(BusNetworkOptions& options);

}  // namespace canvoy::bus_line
