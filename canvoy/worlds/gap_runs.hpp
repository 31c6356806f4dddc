// Runs of each world that are drawn by a seed, for tests and campaigns. One row of the table
// registers a world.
//
//     for (const SimulatedWorld& world : simulated_worlds()) {
//       for (const std::string& wrong : world.soak(17).wrong) report(world.name, wrong);
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// A run with one gap in the communication: all judgements of the world must hold, and nothing may
/// stand still for longer than the gap and its time of detection.
struct GapRun {
  std::string fault;               ///< as `canvoy run WORLD --fault` takes it
  std::vector<std::string> wrong;  ///< a line for each failure; empty: there was none
  Duration time{};                 ///< simulated with the gap in it
};

/// Hours with faults, in which all must hold; and the same with a sabotage that must be detected.
struct SoakRun {
  std::vector<std::string> wrong;  ///< a line for each wrong verdict; empty: there was none
  Duration time{};                 ///< simulated with faults and without a sabotage
  Duration sabotaged_time{};       ///< simulated with a sabotage as well
  std::size_t faults = 0;          ///< that began within `time`
};

/// A world that can be run by a seed.
struct SimulatedWorld {
  const char* name = "";                          ///< as in `canvoy run NAME`
  GapRun (*gap)(std::uint64_t seed) = nullptr;    ///< a run with one gap; returns what was wrong
  SoakRun (*soak)(std::uint64_t seed) = nullptr;  ///< with faults alone and in pairs
};
/// All worlds.
std::span<const SimulatedWorld> simulated_worlds();

}  // namespace canvoy
