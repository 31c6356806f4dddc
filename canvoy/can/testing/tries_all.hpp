// The extent of a test. Slow tests have two sizes: one that finds nearly all errors, each time, and
// the complete one if the environment has CANVOY_TESTS=all, before a release.
//
//     const std::uint64_t seeds = tries_all() ? 10 : 2;
#pragma once

#include <cstdlib>
#include <string_view>

namespace canvoy {

inline bool tries_all() {
  const char* const wanted = std::getenv("CANVOY_TESTS");
  return wanted != nullptr && std::string_view(wanted) == "all";
}

}  // namespace canvoy
