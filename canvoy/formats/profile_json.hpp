// Writes a profile as JSON Lines, one line for each item. docs/profile-json.md describes the lines;
// their keys are stable.
//
//     write_profile_json(cia447::profile, [](const std::string& line) { puts(line.c_str()); });
#pragma once

#include <functional>
#include <string>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::formats {

/// Calls `write` for each line, without its end.
void write_profile_json(const Profile& profile,
                        const std::function<void(const std::string& line)>& write);

}  // namespace canvoy::formats
