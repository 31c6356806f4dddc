// The object that a user means: `6010`, `6383:1`, `0x1018:4`, or the name that a profile gives it.
#pragma once

#include <string_view>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

/// Looks in the profile with the number or the device type (1000h) `profile`, or, where that is 0,
/// in all of them; then in CiA 301. Throws UsageError where there is no such object, or where
/// several profiles have one of this name.
ObjectAddress parse_object(std::string_view text, unsigned profile = 0);

/// Whether finding the object needs the profile of the node: the text is a name, or an index of the
/// profile area.
bool needs_profile(std::string_view text);

}  // namespace canvoy::tools
