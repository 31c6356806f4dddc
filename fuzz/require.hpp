// Conditions that must hold for any input of a fuzzer.
//
//     require(frame.length <= 8);
#pragma once

#include <cstdlib>

namespace canvoy::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace canvoy::fuzz
