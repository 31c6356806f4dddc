#include "canvoy/tools/live/object_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Without case, and with blanks for what stands for them in names.
std::string plain(std::string_view text) {
  std::string made(text);
  for (char& c : made) {
    c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return made;
}

Json entry_json(const ObjectInfo& object, const EntryInfo& entry) {
  Json json{{"sub", fmt::format("{:02X}", entry.sub_first)},
            {"name", name_of(object, entry)},
            {"type", formats::data_type_name(entry.type)},
            {"access", formats::access_name(entry.access)}};
  if (entry.last_sub() != entry.sub_first) {
    json["last_sub"] = fmt::format("{:02X}", entry.last_sub());
  }
  if (entry.value.unit != Unit::none) json["unit"] = symbol(entry.value.unit);
  if (entry.value.limits.kind == Limits::Kind::absolute) {
    const auto [low, high] = NumberRules(entry.value, bits_of(entry)).physical_range();
    json["low"] = low;
    json["high"] = high;
  }
  Json names = Json::array();
  for (const NamedValue& named : entry.value.names) {
    if (named.meaning != Meaning::reserved) names.push_back(named.name);
  }
  if (!names.empty()) json["names"] = std::move(names);
  return json;
}

Json object_json(const ObjectInfo& object, std::string_view profile) {
  Json json{{"object", fmt::format("{:04X}", object.index)}, {"name", object.name}};
  if (object.count > 1) json["count"] = object.count;
  json["profile"] = profile;
  if (!object.clause.empty()) json["clause"] = object.clause;
  Json entries = Json::array();
  for (const EntryInfo& entry : object.entries()) entries.push_back(entry_json(object, entry));
  json["entries"] = std::move(entries);
  return json;
}

bool is_sought(const ObjectInfo& object, const std::string& search) {
  if (search.empty() || plain(object.name).find(search) != std::string::npos) return true;
  if (plain(fmt::format("{:04X}", object.index)).find(search) != std::string::npos) return true;
  return std::ranges::any_of(object.entries(), [&](const EntryInfo& entry) {
    return plain(entry.name).find(search) != std::string::npos;
  });
}

}  // namespace

Json object_list_json(const Profile& profile, std::string_view search) {
  const std::string sought = plain(search);
  Json all = Json::array();
  const Profile* last = nullptr;
  for (const Profile* each : {&profile, profile.base, &base_profile()}) {
    if (each == nullptr || each == last) continue;
    last = each;
    for (const ObjectInfo* object : each->objects) {
      if (all.size() == listed_objects_max) return all;
      if (is_sought(*object, sought)) all.push_back(object_json(*object, each->name));
    }
  }
  return all;
}

}  // namespace canvoy::tools
