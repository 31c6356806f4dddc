// Compares what the driver reads on the slip at signing off, line by line, with the trips and
// payments of the shift.
//
//     const SlipVerdict read = judge_slip(paper, trips, truth, shift);
//     read.wrong_lines
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "canvoy/worlds/taxi/fare_referee.hpp"
#include "canvoy/worlds/taxi/paper_lines.hpp"

namespace canvoy::taxi {

/// A shift as it was, from the first key to the last.
struct DrivenShift {
  Time begin{};       ///< the driver signs on
  Time end{};         ///< the driver signs off
  double metres = 0;  ///< metres driven
};

/// Errors, and the amount of text that was read.
struct SlipVerdict {
  std::uint64_t wrong_lines = 0;  ///< wrong or missing lines
  std::uint64_t lines = 0;        ///< lines read, or missing
};

/// Judges the slip on a piece of paper, of a shift that no fault has affected. It must be the
/// meter's first shift: the total time is at least that of the shift.
SlipVerdict judge_slip(std::span<const std::string> lines, std::span<const Trip> trips,
                       const PaperTruth& truth, const DrivenShift& shift);

}  // namespace canvoy::taxi
