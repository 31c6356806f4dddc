// The names that a filter may use: of all objects, entries and fields of all profiles, and of the
// data sheets that the user gave.
//
//     FilterNames names;
//     names.find({.name = "temperature"});  // each entry of each profile with this in its name
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/description.hpp"
#include "canvoy/tools/filter/filter_ranges.hpp"

namespace canvoy::tools {

/// For comparing: in lower case, with a blank for `_` and `-`, and `, ` for `:` and `,`.
std::string plain_name(std::string_view name);
/// Whether a part of a plain name is `part`: not a part of one of its numbers.
bool has_name(std::string_view name, std::string_view part);
/// The same, and any number stands for any other: descriptions have `#` in place of them.
bool has_name_but_for_numbers(std::string_view name, std::string_view part);
bool is_name_but_for_numbers(std::string_view name, std::string_view other);

/// Which objects a filter is about: by their numbers, or by a name. With neither it is all.
struct FilterObject {
  std::optional<FilterRange> indices = {};
  std::optional<std::uint8_t> sub = {};
  std::string name = {};  ///< a plain one

  friend bool operator==(const FilterObject&, const FilterObject&) = default;
};

/// An entry, or a field of it, that a filter may be about.
struct FilterCandidate {
  const Profile* profile = nullptr;
  const ObjectInfo* object = nullptr;
  const EntryInfo* entry = nullptr;
  const FieldInfo* field = nullptr;  ///< null: the whole entry, as it has no fields

  const ValueInfo& value() const { return field != nullptr ? field->value : entry->value; }
  /// A number that stands for an amount, or a state: no code.
  bool is_amount() const {
    return (is_integer(entry->type) || is_real(entry->type)) &&
           value().notation != Notation::hexadecimal;
  }
};

class FilterNames {
 public:
  /// Those of all profiles.
  FilterNames();
  /// Another one, which has to outlive this: of a data sheet, or another reading.
  void add(const Profile& profile);

  /// Linear in the names of all profiles.
  std::vector<FilterCandidate> find(const FilterObject& object) const;
  /// All names, as they are printed but for numbers: those of objects first.
  std::vector<std::string> all() const;

 private:
  struct Named {
    FilterCandidate candidate;
    std::string name;  ///< plain, with `#` for numbers: `input group #, virtual input #`
  };

  std::vector<Named> named_;
};

}  // namespace canvoy::tools
