// A profile as people name it on the command line.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

/// `447-3`, `447` or `CiA 447-3`.
inline const Profile& parse_profile(std::string_view text) {
  if (const Profile* profile = find_profile(text)) return *profile;
  std::vector<std::string_view> names;
  for (const Profile* profile : all_profiles()) names.push_back(short_name(*profile));
  throw UsageError(fmt::format("'{}' is no profile: {}", text, fmt::join(names, ", ")));
}

}  // namespace canvoy::tools
