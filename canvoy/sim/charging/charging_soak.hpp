// The chargers and batteries of a soak: a seed decides the battery, its state, who else is on the
// bus, and which faults come, alone and in pairs.
//
//     ChargingNetwork network(soak_charging(17));
//     network.run_until(Time(charging_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/sim/charging/charging_network.hpp"

namespace canvoy::charging {

inline constexpr Duration charging_soak_time = 60min;

/// Faults within `time`, some at its start. The last one begins 30 s before the end and stays: the
/// battery is not ready, so that no current may flow.
ChargingOptions soak_charging(std::uint64_t seed, Duration time = charging_soak_time);
/// A verdict may be wrong in the other direction as well: shortly before that last fault the
/// contactor is welded, current flows whatever the charger wants, and that has to be seen.
void weld_contactor(ChargingNetwork& network, Duration time = charging_soak_time);

}  // namespace canvoy::charging
