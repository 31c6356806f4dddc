// Runs of each world with one gap in its communication, drawn by a seed: what the world judges has
// to hold, and nothing may stand still for longer than the gap and the time in which it is noticed.
//
//     const GapRun run = lift_gap(17);
//     if (!run.wrong.empty()) report(run.fault, run.wrong);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace canvoy {

struct GapRun {
  std::string fault;               ///< as `canvoy run WORLD --fault` takes it
  std::vector<std::string> wrong;  ///< a line for each thing; empty: nothing was
};

/// A world, and how one of its runs is drawn.
struct GapWorld {
  const char* name = "";
  GapRun (*run)(std::uint64_t seed) = nullptr;
};
std::span<const GapWorld> gap_worlds();

}  // namespace canvoy
