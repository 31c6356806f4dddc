#include "canvoy/tools/bus/object_argument.hpp"

#include <fmt/format.h>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr unsigned profile_first = 0x6000;

}  // namespace

ObjectAddress parse_object(std::string_view text, unsigned profile) {
  const Profile* const known = profile == 0 ? nullptr : find_profile(profile);
  if (const auto address = find_address(known == nullptr ? base_profile() : *known, text)) {
    return *address;
  }
  if (known == nullptr) {
    for (const Profile* candidate : all_profiles()) {
      if (const auto address = find_address(*candidate, text)) return *address;
    }
  }
  throw UsageError(
      fmt::format("'{}' is no object{}: give an index as 6010 or 1018:4, or a name of the profile",
                  text, known == nullptr ? "" : fmt::format(" of {} or CiA 301", known->name)));
}

bool needs_profile(std::string_view text) {
  const auto address = find_address(base_profile(), text);
  return !address || address->index >= profile_first;
}

}  // namespace canvoy::tools
