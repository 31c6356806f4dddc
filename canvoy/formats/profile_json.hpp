// A profile as JSON Lines: a line for each thing that it says. docs/profile-json.md describes the
// lines; their keys are stable.
//
//     write_profile_json(cia447::profile, [](const std::string& line) { puts(line.c_str()); });
#pragma once

#include <functional>
#include <string>

#include "canvoy/profiles/description.hpp"

namespace canvoy::formats {

/// Hands out the lines one by one, without their ends.
void write_profile_json(const Profile& profile,
                        const std::function<void(const std::string& line)>& write);

}  // namespace canvoy::formats
