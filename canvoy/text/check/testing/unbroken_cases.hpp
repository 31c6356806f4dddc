// The cases of which no broken device is found in the tests, each with its reason. The list only
// gets shorter: a case that is found must leave it (every_case_test.cpp, profile_sweep_test.cpp),
// and docs/evidence.md shows it.
//
//     if (!is_unbroken("419-6001-type")) ADD_FAILURE();
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace canvoy::conformance {

struct UnbrokenCase {
  std::string_view id;
  std::string_view reason;
};

/// By their names.
inline const std::vector<UnbrokenCase> unbroken_cases = {};

inline bool is_unbroken(std::string_view id) {
  return std::ranges::find(unbroken_cases, id, &UnbrokenCase::id) != unbroken_cases.end();
}

}  // namespace canvoy::conformance
