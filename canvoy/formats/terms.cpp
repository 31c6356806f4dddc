#include "canvoy/formats/terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace canvoy::formats {

namespace {

struct TypeName {
  DataType type;
  std::string_view name;
};
constexpr auto type_names = [] {
  using enum DataType;
  return std::to_array<TypeName>({
      {boolean, "BOOLEAN"},
      {integer8, "INTEGER8"},
      {integer16, "INTEGER16"},
      {integer32, "INTEGER32"},
      {unsigned8, "UNSIGNED8"},
      {unsigned16, "UNSIGNED16"},
      {unsigned32, "UNSIGNED32"},
      {real32, "REAL32"},
      {visible_string, "VISIBLE_STRING"},
      {octet_string, "OCTET_STRING"},
      {unicode_string, "UNICODE_STRING"},
      {time_of_day, "TIME_OF_DAY"},
      {time_difference, "TIME_DIFFERENCE"},
      {domain, "DOMAIN"},
      {integer24, "INTEGER24"},
      {real64, "REAL64"},
      {integer40, "INTEGER40"},
      {integer48, "INTEGER48"},
      {integer56, "INTEGER56"},
      {integer64, "INTEGER64"},
      {unsigned24, "UNSIGNED24"},
      {unsigned40, "UNSIGNED40"},
      {unsigned48, "UNSIGNED48"},
      {unsigned56, "UNSIGNED56"},
      {unsigned64, "UNSIGNED64"},
      {utf8_string, "UTF8_STRING"},
  });
}();

constexpr auto odd_type_names = std::to_array<std::string_view>(
    {"UNSIGNED2",  "UNSIGNED3",  "UNSIGNED4",  "UNSIGNED5",  "UNSIGNED6",  "UNSIGNED7",
     "UNSIGNED9",  "UNSIGNED10", "UNSIGNED11", "UNSIGNED12", "UNSIGNED13", "UNSIGNED14",
     "UNSIGNED15", "UNSIGNED17", "UNSIGNED18", "UNSIGNED19", "UNSIGNED20", "UNSIGNED21",
     "UNSIGNED22", "UNSIGNED23", "UNSIGNED25", "UNSIGNED26", "UNSIGNED27", "UNSIGNED28",
     "UNSIGNED29", "UNSIGNED30", "UNSIGNED31"});
constexpr unsigned first_odd = static_cast<unsigned>(DataType::unsigned2);

/// `a 1 to a 4`, or the plain name if it has no number.
std::string numbered_range(std::string_view name, unsigned first, unsigned last) {
  if (first == last || name.find('#') == std::string_view::npos) return numbered(name, first);
  return fmt::format("{} to {}", numbered(name, first), numbered(name, last));
}

std::string range_text(const FieldCondition& condition) {
  if (condition.first == condition.last) return fmt::format("{:02X}h", condition.first);
  return fmt::format("{:02X}h to {:02X}h", condition.first, condition.last);
}

}  // namespace

std::string_view data_type_name(DataType type) {
  const unsigned odd = static_cast<unsigned>(type) - first_odd;
  if (odd < odd_type_names.size()) return odd_type_names[odd];
  const auto* found = std::ranges::find(type_names, type, &TypeName::type);
  return found == type_names.end() ? "" : found->name;
}

std::optional<DataType> data_type_named(std::string_view name) {
  const auto* found = std::ranges::find(type_names, name, &TypeName::name);
  if (found != type_names.end()) return found->type;
  const auto* odd = std::ranges::find(odd_type_names, name);
  if (odd == odd_type_names.end()) return std::nullopt;
  return static_cast<DataType>(first_odd + static_cast<unsigned>(odd - odd_type_names.begin()));
}

std::string_view object_code_name(ObjectCode code) {
  switch (code) {
    case ObjectCode::domain:
      return "DOMAIN";
    case ObjectCode::var:
      return "VAR";
    case ObjectCode::array:
      return "ARRAY";
    case ObjectCode::record:
      return "RECORD";
  }
  return "";
}

std::string_view access_name(Access access) {
  if (allows(access, Access::const_)) return "const";
  if (allows(access, Access::rw)) return "rw";
  if (allows(access, Access::ro)) return "ro";
  return allows(access, Access::wo) ? "wo" : "";
}

std::string_view access_name(const EntryInfo& entry) {
  return entry.access_by_device ? "vd" : access_name(entry.access);
}

std::string_view mapping_name(Mapping mapping) {
  constexpr std::string_view names[] = {"no", "optional", "default"};
  return names[static_cast<unsigned>(mapping)];
}

std::string_view category_name(Category category) {
  constexpr std::string_view names[] = {"mandatory", "optional", "conditional"};
  return names[static_cast<unsigned>(category)];
}

std::string_view meaning_name(Meaning meaning) {
  constexpr std::string_view names[] = {"state",           "not available", "failure",
                                        "not implemented", "do not care",   "manufacturer-specific",
                                        "reserved",        "padding"};
  return names[static_cast<unsigned>(meaning)];
}

double real_value(std::int64_t pattern, DataType type) {
  if (type == DataType::real64) return std::bit_cast<double>(pattern);
  return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(pattern)));
}

std::string pattern_text(std::int64_t number, unsigned bits) {
  const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (1ULL << bits) - 1;
  return fmt::format("{:0{}X}", static_cast<std::uint64_t>(number) & mask, (bits + 3) / 4);
}

std::string numbered(std::string_view name, unsigned number) {
  if (number == no_number) return std::string(name);
  const std::size_t place = name.find('#');
  if (place == std::string_view::npos) return std::string(name);
  return fmt::format("{}{}{}", name.substr(0, place), number, name.substr(place + 1));
}

std::string object_name(const Profile& profile, const ObjectInfo& object, unsigned index) {
  return numbered(object.name, (index - object.index) % profile.block_pitch + object.first_number);
}

std::string object_name(const ObjectInfo& object) {
  return numbered_range(object.name, object.first_number, object.first_number + object.count - 1U);
}

std::string entry_name(const ObjectInfo& object, const EntryInfo& entry, unsigned sub) {
  return numbered(name_of(object, entry), entry.first_number + sub - entry.sub_first);
}

std::string entry_name(const ObjectInfo& object, const EntryInfo& entry) {
  if (entry.name.empty()) return object_name(object);
  const unsigned count = entry.last_sub() - unsigned{entry.sub_first};
  return numbered_range(name_of(object, entry), entry.first_number, entry.first_number + count);
}

std::string field_name(const FieldInfo& field) {
  return numbered(field.name, field.number);
}

std::string condition_text(const FieldInfo& field) {
  std::string text;
  std::string_view last;
  for (const FieldCondition& condition : field.when) {
    if (condition.field == last) {
      text += ", " + range_text(condition);
    } else {
      text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", condition.field,
                          range_text(condition));
    }
    last = condition.field;
  }
  return text;
}

}  // namespace canvoy::formats
