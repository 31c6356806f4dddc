#include "canvoy/profiles/registry.hpp"

#include <algorithm>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/cia401.hpp"
#include "canvoy/profiles/cia402.hpp"
#include "canvoy/profiles/cia406.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/profiles/cia852.hpp"

namespace canvoy {

namespace {

constexpr const Profile* profiles[] = {
    &cia301::profile, &cia401::profile, &cia402::profile, &cia406::profile, &cia407::profile,
    &cia417::profile, &cia418::profile, &cia419::profile, &cia447::profile, &cia852::profile};

constexpr bool is_filler(char c) {
  return c == ' ' || c == '_' || c == '-';
}
constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string_view without_fillers(std::string_view text) {
  while (!text.empty() && is_filler(text.front())) text.remove_prefix(1);
  return text;
}
std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Removes the decimal number at the start of a text and returns it; 0 if there is none.
unsigned take_number(std::string_view& text) {
  constexpr unsigned number_max = 0xFFFF;
  unsigned number = 0;
  for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1)) {
    number = std::min(number * 10 + static_cast<unsigned>(text.front() - '0'), number_max);
  }
  return number;
}

/// `6010`, `6010h`, `0x6010`: all of the text is digits, of the allowed number.
std::optional<unsigned> parse_hex(std::string_view text, std::size_t digits_min,
                                  std::size_t digits_max) {
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
  } else if (text.ends_with('h') || text.ends_with('H')) {
    text.remove_suffix(1);
  }
  if (text.size() < digits_min || text.size() > digits_max) return std::nullopt;
  unsigned number = 0;
  for (const char digit : text) {
    const char c = lower(digit);
    const bool is_decimal = c >= '0' && c <= '9';
    if (!is_decimal && (c < 'a' || c > 'f')) return std::nullopt;
    number = number * 16 + static_cast<unsigned>(is_decimal ? c - '0' : c - 'a' + 10);
  }
  return number;
}

std::optional<unsigned> parse_index(std::string_view text) {
  return parse_hex(text, 4, 4);  // all four: "each" is no index
}
std::optional<unsigned> parse_sub(std::string_view text) {
  return parse_hex(text, 1, 2);
}

ObjectAddress address_of(const Profile& profile, unsigned index, unsigned sub) {
  ObjectAddress address{static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub),
                        find_description(profile, index), nullptr};
  if (address.object != nullptr) address.entry = find_entry(*address.object, sub);
  return address;
}

/// Two parts of an address, split at the first of `separators`; the second may be missing.
struct Parts {
  std::string_view object;
  std::string_view entry;
  bool has_entry = false;
};
Parts split(std::string_view text, std::string_view separators) {
  const std::size_t at = text.find_first_of(separators);
  if (at == std::string_view::npos) return {trimmed(text), {}, false};
  // Not substr(): boards cannot use its error for a position beyond the end.
  return {trimmed({text.begin(), text.begin() + at}), trimmed({text.begin() + at + 1, text.end()}),
          true};
}

/// Index and sub-index as data sheets and other tools write them: `1018:4`, `1018sub4`, `1018/4`,
/// `1018.4`, `1018,4`, `1018[4]`, `1018 4`.
Parts number_parts(std::string_view text) {
  constexpr std::string_view word = "sub";
  if (text.ends_with(']')) text.remove_suffix(1);
  Parts parts = split(text, text.find(':') != std::string_view::npos ? ":" : " /.,[");
  const std::size_t sub = text.find(word);
  if (!parts.has_entry && sub != std::string_view::npos && sub != 0) {
    parts = {{text.begin(), text.begin() + sub}, {text.begin() + sub, text.end()}, true};
  }
  if (parts.entry.starts_with(word)) parts.entry.remove_prefix(word.size());
  return {trimmed(parts.object), trimmed(parts.entry), parts.has_entry};
}

std::optional<ObjectAddress> parse_numbers(const Profile& profile, std::string_view text) {
  const Parts parts = number_parts(text);
  const std::optional<unsigned> index = parse_index(parts.object);
  const std::optional<unsigned> sub = parse_sub(parts.has_entry ? parts.entry : "0");
  if (!index || !sub) return std::nullopt;
  return address_of(profile, *index, *sub);
}

/// Index of the object of this name, with a number if it is one of several: `input group 3`; 0 if
/// there is none.
unsigned find_named(const Profile& profile, std::string_view name) {
  for (const ObjectInfo* object : profile.objects) {
    const std::optional<unsigned> number = match_name(object->name, name);
    if (!number) continue;
    const unsigned position = *number == 0 ? 0 : *number - object->first_number;
    if (position < object->count) return object->index + position;
  }
  return 0;
}

/// The sub-index of the entry of this name, or nothing.
std::optional<unsigned> find_named(const EntryInfo& entry, std::string_view name) {
  const std::optional<unsigned> number = match_name(entry.name, name);
  if (!number) return std::nullopt;
  if (*number == 0) return entry.sub_first;
  const unsigned sub = entry.sub_first + *number - entry.first_number;
  if (*number < entry.first_number || sub > entry.last_sub()) return std::nullopt;
  return sub;
}

std::optional<ObjectAddress> entry_of(const Profile& profile, unsigned index, const Parts& parts) {
  const ObjectInfo& object = *find_object(profile, index);
  ObjectAddress address{static_cast<std::uint16_t>(index), 0, &object, nullptr};
  if (!parts.has_entry) {
    address.entry = find_entry(object, 0);
    return address;
  }
  if (const std::optional<unsigned> sub = parse_sub(parts.entry)) {
    address.sub = static_cast<std::uint8_t>(*sub);
    address.entry = find_entry(object, *sub);
    return address;
  }
  for (const EntryInfo& entry : object.entries()) {
    const std::optional<unsigned> sub = find_named(entry, parts.entry);
    if (!sub) continue;
    address.sub = static_cast<std::uint8_t>(*sub);
    address.entry = &entry;
    return address;
  }
  return std::nullopt;
}

/// An entry that only one object of the profile has, beside sub-index 00h.
std::optional<ObjectAddress> find_only_entry(const Profile& profile, std::string_view name) {
  std::optional<ObjectAddress> found;
  for (const ObjectInfo* object : profile.objects) {
    for (const EntryInfo& entry : object->entries()) {
      const std::optional<unsigned> sub = find_named(entry, name);
      if (entry.sub_first == 0 || !sub) continue;
      if (found) return std::nullopt;
      found = {object->index, static_cast<std::uint8_t>(*sub), object, &entry};
    }
  }
  return found;
}

/// Names of objects have priority over those of entries.
std::optional<ObjectAddress> find_by_name(std::span<const Profile* const> candidates,
                                          const Parts& parts) {
  for (const Profile* candidate : candidates) {
    if (const unsigned index = find_named(*candidate, parts.object)) {
      return entry_of(*candidate, index, parts);
    }
  }
  if (parts.has_entry) return std::nullopt;
  for (const Profile* candidate : candidates) {
    if (const std::optional<ObjectAddress> found = find_only_entry(*candidate, parts.object)) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace

std::span<const Profile* const> all_profiles() {
  return profiles;
}
const Profile& base_profile() {
  return cia301::profile;
}

const Profile* find_profile(std::uint32_t device_type) {
  for (const Profile* profile : profiles) {
    if (profile->device_types.fits(device_type)) return profile;
  }
  const std::uint32_t number = device_type & 0xFFFF;
  for (const Profile* profile : profiles) {
    if (profile->device_types.mask != 0 || profile == &base_profile()) continue;
    if (profile->number == number) return profile;
  }
  return nullptr;
}

std::string_view short_name(const Profile& profile) {
  constexpr std::string_view prefix = "CiA ";
  std::string_view name = profile.name;
  name.remove_prefix(prefix.size());
  return name;
}

const Profile* find_profile(std::string_view name) {
  name = trimmed(name);
  for (const std::string_view publisher : {"CiA", "DSP", "DS"}) {
    const bool is_named =
        name.size() > publisher.size() && same_name({name.data(), publisher.size()}, publisher);
    if (is_named) name = without_fillers({name.begin() + publisher.size(), name.end()});
  }
  for (const Profile* profile : profiles) {
    std::string_view own = short_name(*profile);
    if (own == name) return profile;
    if (own.find('-') != std::string_view::npos) own.remove_suffix(own.size() - own.find('-'));
    if (own == name) return profile;
  }
  return nullptr;
}

const ObjectInfo* find_description(const Profile& profile, unsigned index) {
  for (const Profile* candidate : {&profile, profile.base, &cia301::profile, &cia302::profile}) {
    if (candidate == nullptr) continue;
    if (const ObjectInfo* object = find_object(*candidate, index)) return object;
  }
  return nullptr;
}

std::optional<ObjectAddress> find_address(const Profile& profile, std::string_view text) {
  text = trimmed(text);
  if (const std::optional<ObjectAddress> address = parse_numbers(profile, text)) return address;
  const Parts parts = split(text, ":");
  const Profile& base = profile.base != nullptr ? *profile.base : profile;
  const Profile* const first[] = {&profile, &base, &cia301::profile};
  const Profile* const last[] = {&cia302::profile};
  // A colon may be part of a name: "Joystick 2: x-dimension"; python-canopen has a dot in place of
  // it.
  for (const Parts& reading : {parts, Parts{text, {}, false}, split(text, ".")}) {
    if (const std::optional<ObjectAddress> found = find_by_name(first, reading)) return found;
    if (const std::optional<ObjectAddress> found = find_by_name(last, reading)) return found;
  }
  return std::nullopt;
}

bool same_name(std::string_view a, std::string_view b) {
  return match_name(a, b).has_value();
}

std::optional<unsigned> match_name(std::string_view pattern, std::string_view text) {
  if (pattern.empty() || text.empty()) return std::nullopt;
  unsigned number = 0;
  while (true) {
    pattern = without_fillers(pattern);
    text = without_fillers(text);
    if (pattern.empty()) return text.empty() ? std::optional(number) : std::nullopt;
    // A maker's "Motor #2" is also found by its own name.
    const bool is_itself = pattern.front() == '#' && !text.empty() && text.front() == '#';
    if (pattern.front() == '#' && !is_itself) {
      pattern.remove_prefix(1);
      number = take_number(text);
      continue;
    }
    if (text.empty() || lower(pattern.front()) != lower(text.front())) return std::nullopt;
    pattern.remove_prefix(1);
    text.remove_prefix(1);
  }
}

}  // namespace canvoy
