// Number of occurrences, with the times of the first and the last.
//
//     Tally late;
//     late.add(now);
//     if (late.count > 2) ...
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::text {

/// A count, with the times of the first and the last occurrence.
struct Tally {
  std::uint64_t count = 0;  ///< number of occurrences; 0: none
  Time first{};             ///< valid if count is not 0
  Time last{};              ///< valid if count is not 0

  /// Counts `times` (1 or more) occurrences at `at`; times must not decrease.
  void add(Time at, std::uint64_t times = 1) {
    if (count == 0) first = at;
    count += times;
    last = at;
  }
};

}  // namespace canvoy::text
