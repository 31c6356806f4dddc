// Text of a profile.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

/// One line for each profile.
std::string profile_list_text();
/// Objects, virtual devices, PDOs and emergency codes of a profile, one per line, and its
/// provisions (provisions_text.hpp).
std::string profile_text(const Profile& profile);
/// A whole object: all entries, fields and values; or one of the entries (`only`).
std::string object_details_text(const Profile& profile, const ObjectInfo& object,
                                const EntryInfo* only = nullptr);
/// Objects of the profile with `word` in their name, ignoring case and separators; if there are
/// none, those with an entry, a field or a value of such a name.
std::vector<const ObjectInfo*> find_objects(const Profile& profile, std::string_view word);
/// One line for an object.
std::string object_line(const ObjectInfo& object);

}  // namespace canvoy::tools
