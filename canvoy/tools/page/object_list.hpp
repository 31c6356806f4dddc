// The objects of a node by its profile, as JSON, for a page that lists them before anything was
// read. docs/web.md has the keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::tools {

inline constexpr std::size_t listed_objects_max = 300;

/// Objects of the profile, its base and CiA 301 with all words of `search` in a name or the index.
/// Best matches first: index or name, start of the name, whole words, parts of words, then entries;
/// communication parameters (1000h to 1FFFh) last. The first entry of an array stands for all.
nlohmann::ordered_json object_list_json(const Profile& profile, std::string_view search);

}  // namespace canvoy::tools
