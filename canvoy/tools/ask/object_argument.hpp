// The object that a user means: `6010`, `6383:1`, `0x1018:4`, the name that a profile gives it
// (`battery_parameters:ah_capacity`, or `battery_parameters, ah_capacity` as it is printed), a part
// of it that only one has, or the name that the partner's profile has for the same value.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

/// Looks in the profile with the number or the device type (1000h) `profile`, or, where that is 0,
/// in all of them; then in CiA 301. Throws UsageError where there is no such object, with those
/// that may be meant where there are several.
ObjectAddress parse_object(std::string_view text, unsigned profile = 0);

/// Throws UsageError where no profile that may be meant has such an object.
void check_object(std::string_view text, unsigned profile = 0);

/// Whether finding the object needs the profile of the node: the text is a name, or an index of the
/// profile area.
bool needs_profile(std::string_view text);

/// As parse_object() takes it: `temperature`, `battery_parameters, ah_capacity`.
std::string described_name(const ObjectInfo& object, const EntryInfo& entry);
/// The same of an address, and `6010h:00h` where nobody knows it.
std::string described_name(const ObjectAddress& address);

}  // namespace canvoy::tools
