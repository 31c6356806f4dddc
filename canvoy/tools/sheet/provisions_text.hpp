// Text of the provisions of a profile: a part of profile_text.hpp.
#pragma once

#include <string>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::tools {

/// Bit rates, index ranges, configurations, abort codes, failures, rules, codings and commands,
/// with a heading for each kind; empty if the profile has no provisions.
std::string provisions_text(const Profile& profile);
/// The provisions about one object, without headings and indented like its entries.
std::string provisions_text(const Profile& profile, const ObjectInfo& object);

/// Text of a virtual device: `03h Passenger information, class 1 destination indicator`.
std::string device_text(const VirtualDeviceInfo& device);

}  // namespace canvoy::tools
