// How often something was seen, and when first and last.
//
//     Tally late;
//     late.add(now);
//     if (late.count > 2) ...
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::words {

/// A count, and the times of the first and the latest.
struct Tally {
  std::uint64_t count = 0;  ///< how often; 0: never
  Time first{};             ///< only where the count is not 0
  Time last{};              ///< only where the count is not 0

  /// Seen at `at`, `times` times at once (1 or more); times come in order.
  void add(Time at, std::uint64_t times = 1) {
    if (count == 0) first = at;
    count += times;
    last = at;
  }
};

}  // namespace canvoy::words
