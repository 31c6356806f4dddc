// What a profile says beside its objects, as a person wants to read it: a part of profile_text.hpp.
#pragma once

#include <string>

#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

/// Bit rates, index ranges, configurations, abort codes, failures, rules, codings and commands,
/// with a heading for each kind that there is; empty where the profile has no provisions.
std::string provisions_text(const Profile& profile);
/// Those that are about one object, without headings and indented as its entries are.
std::string provisions_text(const Profile& profile, const ObjectInfo& object);

/// `03h Passenger information, class 1 destination indicator`
std::string device_text(const VirtualDeviceInfo& device);

}  // namespace canvoy::tools
