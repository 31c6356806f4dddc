// What a profile says beside its objects, as JSON Lines: a part of what profile_json.hpp writes.
#pragma once

#include <functional>
#include <string>

#include "canvoy/profiles/description.hpp"

namespace canvoy::formats {

/// Calls `write` for each line; for none where the profile has no provisions.
void write_provisions_json(const Profile& profile,
                           const std::function<void(const std::string& line)>& write);

}  // namespace canvoy::formats
