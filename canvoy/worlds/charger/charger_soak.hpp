// The chargers and batteries of a soak: a seed decides the battery, its state, the other devices on
// the bus, and which faults occur, alone and in pairs.
//
//     ChargerNetwork network(soak_charging(17));
//     network.run_until(Time(charging_soak_time));
//     if (!network.all_hold()) report(17);
#pragma once

#include <cstdint>

#include "canvoy/worlds/charger/charger_network.hpp"

namespace canvoy::charger {

inline constexpr Duration charging_soak_time = 60min;  ///< length of a run of a soak

/// Draws faults within `time`, some at its start. The last one begins 30 s before the end and
/// stays: the battery is not ready, so that no current may flow.
ChargerOptions soak_charging(std::uint64_t seed, Duration time = charging_soak_time);
/// Adds an error that verdicts must detect, since they may be wrong in the other direction as well:
/// shortly before the last fault, the contactor is welded, so that current flows whatever the
/// charger requests.
void weld_contactor(ChargerNetwork& network, Duration time = charging_soak_time);

}  // namespace canvoy::charger
