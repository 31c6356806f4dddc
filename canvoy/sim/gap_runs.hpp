// Runs of each world that are drawn by a seed, as tests and campaigns try them. One row of the
// table registers a world.
//
//     for (const SimulatedWorld& world : simulated_worlds()) {
//       for (const std::string& wrong : world.soak(17)) report(world.name, wrong);
//     }
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace canvoy {

/// A run with one gap in the communication: what the world judges has to hold, and nothing may
/// stand still for longer than the gap and the time in which it is noticed.
struct GapRun {
  std::string fault;               ///< as `canvoy run WORLD --fault` takes it
  std::vector<std::string> wrong;  ///< a line for each thing; empty: nothing was
};

struct SimulatedWorld {
  const char* name = "";
  GapRun (*gap)(std::uint64_t seed) = nullptr;
  /// Hours with faults, alone and in pairs, in which all has to hold; and the same with a sabotage,
  /// which has to be seen. A line for each wrong verdict.
  std::vector<std::string> (*soak)(std::uint64_t seed) = nullptr;
};
std::span<const SimulatedWorld> simulated_worlds();

}  // namespace canvoy
