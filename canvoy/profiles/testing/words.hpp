// Meaning of a raw value of a profile's object, in words.
//
//     words(cia417::profile, 0x6300, 1, 0xFFFF)
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy {

inline const EntryInfo& entry_at(const Profile& profile, unsigned index, unsigned sub) {
  static constexpr EntryInfo missing = {};
  const ObjectInfo* object = find_object(profile, index);
  const EntryInfo* entry = object != nullptr ? find_entry(*object, sub) : nullptr;
  EXPECT_NE(entry, nullptr) << std::hex << index << ":" << sub;
  return entry != nullptr ? *entry : missing;
}

/// Finds a field by its name, and its number if there are several; null if there is none.
inline const FieldInfo* field_at(const EntryInfo& entry, std::string_view name,
                                 unsigned number = 0) {
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name && (number == 0 || field.number == number)) return &field;
  }
  return nullptr;
}

/// True if a field exists while the entry has this value.
inline bool holds(const EntryInfo& entry, const FieldInfo& field, std::uint64_t raw) {
  for (const FieldCondition& condition : field.when) {
    bool met = false;
    for (const FieldCondition& other : field.when) {
      const FieldInfo* decides = field_at(entry, other.field);
      if (other.field != condition.field || decides == nullptr) continue;
      const std::int64_t number = extract(raw, bits_of(*decides));
      met = met || (number >= other.first && number <= other.last);
    }
    if (!met) return false;
  }
  return true;
}

inline std::string value_text(const FieldInfo& field, std::uint64_t raw) {
  const std::int64_t number = extract(raw, bits_of(field));
  const NamedValue* named = find_name(field.value, number, field.bits, field.is_signed);
  return named != nullptr ? std::string(named->name) : std::to_string(number);
}

/// The fields that hold, without the reserved ones and zeros of a single bit.
inline std::string words(const Profile& profile, unsigned index, unsigned sub, std::uint64_t raw) {
  const EntryInfo& entry = entry_at(profile, index, sub);
  std::string text;
  for (const FieldInfo& field : entry.fields) {
    const bool is_off = field.bits == 1 && extract(raw, bits_of(field)) == 0;
    if (field.name == "reserved" || is_off || !holds(entry, field, raw)) continue;
    std::string name(field.name);
    if (const auto at = name.find('#'); at != std::string::npos) {
      name.replace(at, 1, std::to_string(field.number));
    }
    text += (text.empty() ? "" : "; ") + name + ": " + value_text(field, raw);
  }
  return text;
}

}  // namespace canvoy
