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
inline const std::vector<UnbrokenCase> unbroken_cases = {
    {"302-program-01", "no device of ours has 1F50h"},
    {"302-program-02", "no device of ours has 1F51h"},
    {"419-link-01", "a charger that does not look for its battery is not linked, and not judged"},
    {"419-link-02", "a charger that does not ask for COB-IDs is not linked, and not judged"},
    {"419-link-07", "what is read of a battery has no party between"},
};

inline bool is_unbroken(std::string_view id) {
  return std::ranges::find(unbroken_cases, id, &UnbrokenCase::id) != unbroken_cases.end();
}

}  // namespace canvoy::conformance
