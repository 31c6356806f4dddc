#include "canvoy/tools/page/object_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Below it are communication parameters (CiA 301, 7.4.1).
constexpr std::uint16_t own_index_first = 0x2000;

/// Ignores case, with blanks for the separators in names.
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

/// The search text as typed, and its words.
struct Sought {
  explicit Sought(std::string_view search) : text(plain(search)) {
    for (std::size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string::npos;) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      words.push_back(text.substr(at, end - at));
      at = end;
    }
  }
  std::string text;
  std::vector<std::string> words{};
};

/// Quality of a match: 0 is best; nothing: not all words occur.
std::optional<unsigned> rank_of(std::string_view name, const Sought& sought) {
  const std::string text = plain(name);
  bool begin_words = true;
  for (const std::string& word : sought.words) {
    if (text.find(word) == std::string::npos) return std::nullopt;
    begin_words = begin_words && (" " + text).find(" " + word) != std::string::npos;
  }
  if (text == sought.text) return 0;
  if (text.starts_with(sought.text)) return 1;
  return begin_words ? 2 : 3;
}

std::optional<unsigned> rank_of(const ObjectInfo& object, const Sought& sought) {
  constexpr unsigned entries_behind = 4;
  constexpr unsigned communication_behind = 8;
  std::optional<unsigned> best = rank_of(fmt::format("{:04X}", object.index), sought);
  const auto take = [&](std::optional<unsigned> rank, unsigned behind) {
    if (rank) best = std::min(best.value_or(~0U), *rank + behind);
  };
  take(rank_of(object.name, sought), 0);
  for (const EntryInfo& entry : object.entries()) {
    take(rank_of(entry.name, sought), entries_behind);
    take(rank_of(fmt::format("{} {}", object.name, entry.name), sought), entries_behind);
  }
  if (best && object.index < own_index_first) *best += communication_behind;
  return best;
}

}  // namespace

Json object_list_json(const Profile& profile, std::string_view search) {
  struct Found {
    unsigned rank;
    const ObjectInfo* object;
    std::string_view profile;
  };
  const Sought sought(search);
  std::vector<Found> found;
  const Profile* last = nullptr;
  for (const Profile* each : {&profile, profile.base, &base_profile()}) {
    if (each == nullptr || each == last) continue;
    last = each;
    for (const ObjectInfo* object : each->objects) {
      if (const auto rank = rank_of(*object, sought)) found.push_back({*rank, object, each->name});
    }
  }
  std::ranges::stable_sort(found, {}, &Found::rank);
  if (found.size() > listed_objects_max) found.resize(listed_objects_max);
  Json all = Json::array();
  for (const Found& each : found) all.push_back(object_json(*each.object, each.profile));
  return all;
}

}  // namespace canvoy::tools
