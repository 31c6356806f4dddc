// The names that a filter may use: of all objects, entries and fields of all profiles, and of the
// data sheets of the user.
//
//     FilterNames names;
//     names.find({.name = "temperature"});  // each entry of each profile with this in its name
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/model/description.hpp"
#include "canvoy/tools/argument/filter_ranges.hpp"

namespace canvoy::tools {

/// Form for comparison: lower case, with a blank for `_` and `-`, and `, ` for `:` and `,`.
std::string plain_name(std::string_view name);
/// True if `part` is a part of a plain name, but not a part of one of its numbers.
bool has_name(std::string_view name, std::string_view part);
/// Like has_name(), but any number matches any other: descriptions have `#` for them.
bool has_name_but_for_numbers(std::string_view name, std::string_view part);
bool is_name_but_for_numbers(std::string_view name, std::string_view other);

/// The objects of a filter: by their numbers, or by a name. With neither, all objects.
struct FilterObject {
  std::optional<FilterRange> indices = {};
  std::optional<std::uint8_t> sub = {};
  std::string name = {};  ///< in plain form

  friend bool operator==(const FilterObject&, const FilterObject&) = default;
};

/// An entry, or a field of it, that a filter may mean.
struct FilterCandidate {
  const Profile* profile = nullptr;
  const ObjectInfo* object = nullptr;
  const EntryInfo* entry = nullptr;
  const FieldInfo* field = nullptr;  ///< null: the whole entry, which has no fields

  const ValueInfo& value() const { return field != nullptr ? field->value : entry->value; }
  /// True for a number that is an amount or a state, not a code.
  bool is_amount() const {
    return (is_integer(entry->type) || is_real(entry->type)) &&
           value().notation != Notation::hexadecimal;
  }
};

class FilterNames {
 public:
  /// Contains the names of all profiles.
  FilterNames();
  /// Adds a profile, which must outlive this: of a data sheet, or another reading.
  void add(const Profile& profile);

  /// Linear in the names of all profiles.
  std::vector<FilterCandidate> find(const FilterObject& object) const;
  /// All names as printed, except for numbers; those of objects first.
  std::vector<std::string> all() const;

 private:
  struct Named {
    FilterCandidate candidate;
    std::string name;  ///< plain, with `#` for numbers: `input group #, virtual input #`
  };

  std::vector<Named> named_;
};

}  // namespace canvoy::tools
