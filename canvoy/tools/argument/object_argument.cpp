#include "canvoy/tools/argument/object_argument.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

constexpr unsigned profile_first = 0x6000;

/// A value goes from one to the other, and has the same index in both (CiA 419, clause 8).
const Profile* partner_of(const Profile& profile) {
  if (&profile == &cia419::profile) return &cia418::profile;
  if (&profile == &cia418::profile) return &cia419::profile;
  return nullptr;
}

/// As written, and as printed: `battery_parameters, ah_capacity`.
std::optional<ObjectAddress> find_written(const Profile& profile, std::string_view text) {
  if (const auto address = find_address(profile, text)) return address;
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  std::string with_colon(text);
  with_colon[comma] = ':';
  return find_address(profile, with_colon);
}

/// By its name in the profile of the partner.
std::optional<ObjectAddress> find_of_partner(const Profile& profile, std::string_view text) {
  const Profile* partner = partner_of(profile);
  if (partner == nullptr) return std::nullopt;
  const auto theirs = find_written(*partner, text);
  if (!theirs || theirs->index < profile_first) return std::nullopt;
  const auto ours = find_address(profile, fmt::format("{:04X}:{:02X}", theirs->index, theirs->sub));
  return ours && ours->entry != nullptr ? ours : std::nullopt;
}

/// True for values: not the number of entries, nor the content of a PDO.
bool is_a_value(const ObjectInfo& object, const EntryInfo& entry) {
  const bool is_counted = entry.sub_first != 0 || object.entries().size() == 1;
  return is_counted && !is_pdo_mapping(object.index);
}

template <class Action>
void each_value(const Profile& profile, const Action& action) {
  for (const ObjectInfo* object : profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      if (is_a_value(*object, entry)) action(*object, entry);
    }
  }
}

/// Profiles that may describe an object of a node.
std::vector<const Profile*> profiles_for(const Profile* known) {
  std::vector<const Profile*> profiles;
  if (known == nullptr) {
    profiles.assign(all_profiles().begin(), all_profiles().end());
  } else {
    profiles = {known, &base_profile()};
    if (known->base != nullptr) profiles.push_back(known->base);
  }
  profiles.push_back(&cia302::profile);
  return profiles;
}

/// The parts of a name: `heartbeat producer-time` has three.
std::vector<std::string> words_of_name(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    constexpr std::string_view between = " _-.,:";
    if (between.find(c) != std::string_view::npos) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  std::ranges::transform(words, words.begin(),
                         [](const std::string& word) { return plain_name(word); });
  std::erase(words, std::string());
  return words;
}

/// Objects with a name that the condition holds for.
template <class Condition>
std::vector<ObjectAddress> find_named(const Profile* known, const Condition& is_meant) {
  std::vector<ObjectAddress> found;
  for (const Profile* profile : profiles_for(known)) {
    each_value(*profile, [&](const ObjectInfo& object, const EntryInfo& entry) {
      if (!is_meant(plain_name(described_name(object, entry)))) return;
      // Profiles share objects: each address of a name is listed once.
      const auto sub = static_cast<std::uint8_t>(entry.sub_first);
      const bool is_there = std::ranges::any_of(found, [&](const ObjectAddress& each) {
        return each.index == object.index && each.sub == sub &&
               described_name(each) == described_name(object, entry);
      });
      if (!is_there) found.push_back({object.index, sub, &object, &entry});
    });
  }
  return found;
}

/// Objects with a name that contains the text; if there are none, those with all of its words in
/// any order.
std::vector<ObjectAddress> find_parts(const Profile* known, std::string_view text) {
  const std::string part = plain_name(text);
  if (part.empty()) return {};
  std::vector<ObjectAddress> found =
      find_named(known, [&part](const std::string& name) { return has_name(name, part); });
  const std::vector<std::string> words = words_of_name(text);
  if (!found.empty() || words.size() < 2) return found;
  return find_named(known, [&words](const std::string& name) {
    return std::ranges::all_of(
        words, [&name](const std::string& word) { return name.find(word) != std::string::npos; });
  });
}

bool is_several(const ObjectAddress& address) {
  return address.object->count > 1 || address.entry->last_sub() != address.entry->sub_first;
}

std::string choice(const ObjectAddress& address) {
  return fmt::format("{} ({}{})", described_name(address),
                     text::object_text(address.index, address.sub),
                     is_several(address) ? " and following" : "");
}

/// All of them, where the node has none.
void keep_those_of_node(std::vector<ObjectAddress>& found, const HasObject& has) {
  constexpr std::size_t asked_max = 16;
  if (found.size() < 2 || found.size() > asked_max) return;
  std::vector<ObjectAddress> there;
  std::ranges::copy_if(found, std::back_inserter(there),
                       [&has](const ObjectAddress& each) { return has(each.index, each.sub); });
  if (!there.empty()) found = std::move(there);
}

[[noreturn]] void refuse_several(std::string_view text, const std::vector<ObjectAddress>& found) {
  constexpr std::size_t shown_max = 6;
  std::vector<std::string> choices;
  for (const ObjectAddress& address : found) {
    if (choices.size() < shown_max) choices.push_back(choice(address));
  }
  const std::size_t hidden = found.size() - choices.size();
  throw UsageError(fmt::format("'{}' may be {}{}: say which", text, fmt::join(choices, "; "),
                               hidden == 0 ? "" : fmt::format("; or {} more", hidden)));
}

/// ` of CiA 418 or CiA 301`
std::string sources_of(const Profile* known) {
  if (known == nullptr) return {};
  const bool is_of_sheet = std::ranges::find(all_profiles(), known) == all_profiles().end();
  return fmt::format(" of {} or CiA 301", is_of_sheet ? "the data sheet" : known->name);
}

[[noreturn]] void refuse_unknown(std::string_view text, const Profile* known) {
  std::vector<std::string> names;
  for (const Profile* profile : profiles_for(known)) {
    each_value(*profile, [&names](const ObjectInfo& object, const EntryInfo& entry) {
      names.emplace_back(object.name);
      if (!entry.name.empty()) names.emplace_back(entry.name);
    });
  }
  throw UsageError(fmt::format(
      "'{}' is no object{}: give an index as 6010 or 1018:4, or a name of the profile{}", text,
      sources_of(known), did_you_mean(text, names)));
}

/// Index and sub-index of a text printed with both: `6010h:00h temperature` in decoded logs,
/// `temperature (6010h:00h)` in choices. Other texts are returned as they are.
std::string_view without_printed_name(std::string_view text) {
  const std::size_t bracket = text.rfind(" (");
  const bool is_choice = bracket != std::string_view::npos && text.ends_with("h)");
  const std::string_view place = is_choice ? text.substr(bracket + 2, text.size() - bracket - 3)
                                           : text.substr(0, text.find(' '));
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::string_view pattern = "....h:..h";
  if (place.size() != pattern.size() || place == text) return text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool is_digit = digits.find(place[i]) != std::string_view::npos;
    if (pattern[i] == '.' ? !is_digit : place[i] != pattern[i]) return text;
  }
  return place;
}

/// Finds a complete name.
std::optional<ObjectAddress> find_whole(std::string_view given, const Profile* known) {
  const std::string_view text = without_printed_name(given);
  if (const auto address = find_written(known == nullptr ? base_profile() : *known, text)) {
    return address;
  }
  if (known != nullptr) return find_of_partner(*known, text);
  for (const Profile* candidate : all_profiles()) {
    if (const auto address = find_written(*candidate, text)) return address;
  }
  return std::nullopt;
}

const Profile* known_profile(const ProfileChoice& profile) {
  if (profile.sheet != nullptr) return profile.sheet;
  return profile.number == 0 ? nullptr : find_profile(profile.number);
}

}  // namespace

ObjectAddress parse_object(std::string_view text, const ProfileChoice& profile,
                           const HasObject& has) {
  const Profile* const known = known_profile(profile);
  if (const auto address = find_whole(text, known)) return *address;
  std::vector<ObjectAddress> found = find_parts(known, text);
  if (has) keep_those_of_node(found, has);
  if (found.empty()) refuse_unknown(text, known);
  if (found.size() > 1 || is_several(found.front())) refuse_several(text, found);
  return found.front();
}

void check_object(std::string_view text, const ProfileChoice& profile) {
  if (profile.number != 0 && find_profile(profile.number) == nullptr) {
    throw UsageError(fmt::format("CiA {} is no profile that is known here", profile.number));
  }
  const Profile* const known = known_profile(profile);
  if (!find_whole(text, known) && find_parts(known, text).empty()) refuse_unknown(text, known);
}

bool needs_profile(std::string_view text) {
  const auto address = find_address(base_profile(), text);
  return !address || address->index >= profile_first;
}

std::string described_name(const ObjectInfo& object, const EntryInfo& entry) {
  std::string name(object.name);
  if (!entry.name.empty() && entry.name != object.name) name.append(", ").append(entry.name);
  return name;
}

std::string described_name(const ObjectAddress& address) {
  if (address.entry == nullptr) return text::object_text(address.index, address.sub);
  return described_name(*address.object, *address.entry);
}

}  // namespace canvoy::tools
