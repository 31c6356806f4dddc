// How often something was seen, and when first and last.
//
//     Tally late;
//     late.add(now);
//     if (late.count > 2) ...
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"

namespace canvoy::words {

struct Tally {
  std::uint64_t count = 0;
  Time first{};
  Time last{};

  void add(Time at, std::uint64_t times = 1) {
    if (count == 0) first = at;
    count += times;
    last = at;
  }
};

}  // namespace canvoy::words
