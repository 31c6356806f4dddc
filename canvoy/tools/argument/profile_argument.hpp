// A profile on the command line.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/formats/sheet/chosen_profile.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// Reads `447-3`, `447` or `CiA 447-3`.
inline const Profile& parse_profile(std::string_view text) {
  if (const Profile* profile = find_profile(text)) return *profile;
  std::vector<std::string_view> names;
  for (const Profile* profile : all_profiles()) names.push_back(short_name(*profile));
  throw UsageError(fmt::format("'{}' is no profile: {}", text, fmt::join(names, ", ")));
}

/// Reads the name of a reading, for a profile with a text that contradicts itself.
inline const ReadingInfo& parse_reading(const Profile& profile, const std::string& name) {
  if (const ReadingInfo* reading = formats::find_reading(profile, name)) return *reading;
  std::vector<std::string_view> names;
  for (const ReadingInfo& reading : profile.readings) names.push_back(reading.name);
  throw UsageError(
      fmt::format("'{}' is no reading of {}: {}", name, profile.name,
                  names.empty() ? "there is but one" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace canvoy::tools
