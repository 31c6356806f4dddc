// The objects that a node of some profile may have, as JSON: for a page that lists them before
// anything was read. docs/web.md has the keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

inline constexpr std::size_t listed_objects_max = 300;

/// Those of the profile, of the one that it is built on, and of CiA 301, of which the name or the
/// index has `search` in it; of an array of like entries the first stands for all.
nlohmann::ordered_json object_list_json(const Profile& profile, std::string_view search);

}  // namespace canvoy::tools
