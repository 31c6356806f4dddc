#include "canvoy/tools/argument/filter_names.hpp"

#include <set>

#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

bool is_decimal(char c) {
  return c >= '0' && c <= '9';
}

/// With `#` for each number, as in descriptions.
std::string without_numbers(std::string_view name) {
  std::string made;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_decimal(name[i])) {
      made += name[i];
    } else if (i == 0 || !is_decimal(name[i - 1])) {
      made += '#';
    }
  }
  return made;
}

bool has_index(const ObjectInfo& object, const Profile& profile, const FilterRange& indices) {
  for (unsigned block = 0; block < profile.block_count; ++block) {
    const std::int64_t first = object.index + std::int64_t{block} * profile.block_pitch;
    if (first <= indices.high && first + object.count > indices.low) return true;
    if (object.once) break;
  }
  return false;
}

}  // namespace

std::string plain_name(std::string_view name) {
  std::string made;
  for (const char c : name) {
    const bool is_blank = c == ' ' || c == '_' || c == '-';
    if (c == ':' || c == ',') {
      while (made.ends_with(' ')) made.pop_back();
      made += ", ";
    } else if (!is_blank) {
      made += in_lower_case(c);
    } else if (!made.empty() && !made.ends_with(' ')) {
      made += ' ';
    }
  }
  while (made.ends_with(' ')) made.pop_back();
  return made;
}

bool has_name(std::string_view name, std::string_view part) {
  if (part.empty()) return true;
  for (std::size_t at = name.find(part); at != std::string_view::npos;
       at = name.find(part, at + 1)) {
    const std::size_t end = at + part.size();
    const bool cuts_front = at > 0 && is_decimal(name[at - 1]) && is_decimal(part.front());
    const bool cuts_end = end < name.size() && is_decimal(name[end]) && is_decimal(part.back());
    if (!cuts_front && !cuts_end) return true;
  }
  return false;
}

bool has_name_but_for_numbers(std::string_view name, std::string_view part) {
  return without_numbers(name).find(without_numbers(part)) != std::string::npos;
}

bool is_name_but_for_numbers(std::string_view name, std::string_view other) {
  return without_numbers(name) == without_numbers(other);
}

FilterNames::FilterNames() {
  for (const Profile* profile : all_profiles()) add(*profile);
  add(cia302::profile);
}

void FilterNames::add(const Profile& profile) {
  for (const ObjectInfo* object : profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      std::string name(object->name);
      if (!entry.name.empty()) name.append(", ").append(entry.name);
      name = without_numbers(plain_name(name));
      if (entry.fields.empty()) named_.push_back({{&profile, object, &entry}, name});
      for (const FieldInfo& field : entry.fields) {
        if (is_reserved(field)) continue;
        const std::string whole = name + ", " + without_numbers(plain_name(field.name));
        named_.push_back({{&profile, object, &entry, &field}, whole});
      }
    }
  }
}

std::vector<FilterCandidate> FilterNames::find(const FilterObject& object) const {
  std::vector<FilterCandidate> found;
  const std::string part = without_numbers(object.name);
  for (const Named& named : named_) {
    const auto& [profile, described, entry, field] = named.candidate;
    if (object.indices && !has_index(*described, *profile, *object.indices)) continue;
    if (object.sub && (*object.sub < entry->sub_first || *object.sub > entry->last_sub())) continue;
    if (named.name.find(part) != std::string::npos) found.push_back(named.candidate);
  }
  return found;
}

std::vector<std::string> FilterNames::all() const {
  std::vector<std::string> names;
  std::set<std::string_view> known;
  const auto add = [&](std::string_view name) {
    if (!name.empty() && known.insert(name).second) names.emplace_back(name);
  };
  for (const Named& named : named_) add(named.candidate.object->name);
  for (const Named& named : named_) {
    add(named.candidate.entry->name);
    if (named.candidate.field != nullptr) add(named.candidate.field->name);
  }
  return names;
}

}  // namespace canvoy::tools
