// What a profile says, as a person wants to read it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/description.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

/// A line for each profile.
std::string profile_list_text();
/// Objects, virtual devices, PDOs and emergency codes of a profile, a line each, and what it says
/// beside them (provisions_text.hpp).
std::string profile_text(const Profile& profile);
/// Whole objects: all entries, fields and values; or one of the entries (`only`).
std::string object_details_text(const Profile& profile, const ObjectInfo& object,
                                const EntryInfo* only = nullptr);
/// Objects of the profile with `word` in their name, case and fillers aside; where there are none,
/// those with an entry, a field or a value of such a name.
std::vector<const ObjectInfo*> find_objects(const Profile& profile, std::string_view word);
/// A line for an object.
std::string object_line(const ObjectInfo& object);

}  // namespace canvoy::tools
