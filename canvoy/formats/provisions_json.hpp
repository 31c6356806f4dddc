// Writes the provisions of a profile, which are no objects, as JSON Lines: a part of the output of
// profile_json.hpp.
#pragma once

#include <functional>
#include <string>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::formats {

/// Calls `write` for each line; not called if the profile has no provisions.
void write_provisions_json(const Profile& profile,
                           const std::function<void(const std::string& line)>& write);

}  // namespace canvoy::formats
