// A sweep of the faults of a bus through the places of a journey: each kind, and each device where
// the kind is of one, begins at a terminal, between two stops and at a stop.
//
//     for (const SweptFault& swept : swept_faults(17)) {
//       for (const std::string& wrong : wrong_verdicts(17, swept)) report(wrong);
//     }
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line {

inline constexpr Duration bus_sweep_time = 45min;  ///< length of a run of the sweep

/// A fault, and where the bus is when it begins.
struct SweptFault {
  std::string_view place{};  ///< `terminal`, `between`, `stop`
  ScheduledFault fault{};    ///< with its time and duration
};

/// Draws the place in time of all faults of the sweep, and how long they last, from 1 s to 10 min.
std::vector<SweptFault> swept_faults(std::uint64_t seed);
/// Plays the fault, in which all must hold; and, where it is at no chosen device, the same with a
/// destination that does not change, which must be seen. Returns a line for each wrong verdict.
std::vector<std::string> wrong_verdicts(std::uint64_t seed, const SweptFault& swept);

}  // namespace canvoy::bus_line
