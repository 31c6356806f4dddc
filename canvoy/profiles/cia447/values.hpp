// Building blocks of the description of CiA 447-3: statuses and commands, their codes, and adjacent
// fields.
//
// All objects of CiA 447-3 are of two kinds. A status is provided by the virtual device that has
// the function, and read by the others, which have it as rw. Its two highest codes are "Failure"
// and "Signal not available". A command is written to the virtual device that has the function. Its
// two highest codes are "Function not implemented" (for a reader) and "Don't care". The remaining
// codes below are reserved.
//
//     inline constexpr auto opening = status_values<3>("Open", "Closed");  // 2 to 5: reserved
//     inline constexpr auto window_fields = side_by_side(field(3, "wd", "window driver", opening),
//                                                        reserved<5>());
//     inline constexpr ObjectInfo window_status_object =
//         variable_object(0x600B, "Window status", "4.2.2.6", "...",
//                  status(DataType::unsigned8, Mapping::by_default, window_fields));
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::cia447 {

// Codes.

/// The highest code of that many bits.
constexpr std::int64_t all_ones(unsigned bits) {
  return static_cast<std::int64_t>((1ULL << bits) - 1);
}

/// The two highest codes of a status or command.
struct Sentinels {
  NamedValue second_highest;  ///< failure, or not implemented
  NamedValue highest;         ///< not available, or no action
};
template <unsigned bits>
inline constexpr Sentinels status_sentinels = {
    {all_ones(bits) - 1, "Failure", Meaning::failure},
    {all_ones(bits), "Signal not available", Meaning::invalid}};
template <unsigned bits>
inline constexpr Sentinels command_sentinels = {
    {all_ones(bits) - 1, "Function not implemented", Meaning::not_implemented},
    {all_ones(bits), "Don't care, take no action", Meaning::do_not_care}};

/// Codes without a meaning.
constexpr NamedValue reserved_codes(std::int64_t first, std::int64_t last) {
  return {first, last, "Reserved", Meaning::reserved};
}

/// Number of named values that `states` states of `bits` bits need.
constexpr std::size_t value_count(unsigned bits, std::size_t states) {
  const auto codes = static_cast<std::size_t>(all_ones(bits)) + 1;
  return states + (states + 2 < codes ? 3U : 2U);
}
/// States from 0 upward, the remaining codes, and the sentinels. The name "Reserved" marks a code
/// as reserved.
template <unsigned bits, std::size_t count>
constexpr auto coded(const std::string_view (&states)[count], const Sentinels& sentinels) {
  std::array<NamedValue, value_count(bits, count)> values{};
  for (std::size_t i = 0; i < count; ++i) {
    const Meaning meaning = states[i] == "Reserved" ? Meaning::reserved : Meaning::state;
    values[i] = NamedValue(i, states[i], meaning);
  }
  if (values.size() == count + 3) {
    values[count] = reserved_codes(static_cast<std::int64_t>(count), all_ones(bits) - 2);
  }
  values[values.size() - 2] = sentinels.second_highest;
  values[values.size() - 1] = sentinels.highest;
  return values;
}
/// The codes of a status with these states, from 0 upward.
template <unsigned bits, std::convertible_to<std::string_view>... Text>
constexpr auto status_values(const Text&... states) {
  return coded<bits, sizeof...(states)>({std::string_view(states)...}, status_sentinels<bits>);
}
/// The codes of a command with these states, from 0 upward.
template <unsigned bits, std::convertible_to<std::string_view>... Text>
constexpr auto command_values(const Text&... states) {
  return coded<bits, sizeof...(states)>({std::string_view(states)...}, command_sentinels<bits>);
}
/// Codes of a two-bit command that uses its second highest code.
constexpr std::array<NamedValue, 4> three_commands(std::string_view first, std::string_view second,
                                                   std::string_view third) {
  return {NamedValue{0, first}, NamedValue{1, second}, NamedValue{2, third},
          command_sentinels<2>.highest};
}

/// Codes, of a number from 0 to `high`, that are no number.
template <unsigned bits, std::int64_t high>
constexpr auto number_names(const Sentinels& sentinels) {
  constexpr bool has_gap = high < all_ones(bits) - 2;
  std::array<NamedValue, has_gap ? 3 : 2> names{};
  names[0] = sentinels.second_highest;
  names[1] = sentinels.highest;
  if constexpr (has_gap) names[2] = reserved_codes(high + 1, all_ones(bits) - 2);
  return names;
}
template <unsigned bits, std::int64_t high>
inline constexpr auto measured_names = number_names<bits, high>(status_sentinels<bits>);
template <unsigned bits, std::int64_t high>
inline constexpr auto wanted_names = number_names<bits, high>(command_sentinels<bits>);

/// The number in a status, from 0 to `high`: by default all codes but the sentinels.
template <unsigned bits, std::int64_t high = all_ones(bits) - 2>
constexpr ValueInfo measured(Unit unit = Unit::none, const Scale& scale = {}) {
  return {
      .unit = unit, .scale = scale, .limits = within(0, high), .names = measured_names<bits, high>};
}
/// The number in a command.
template <unsigned bits, std::int64_t high = all_ones(bits) - 2>
constexpr ValueInfo wanted(Unit unit = Unit::none, const Scale& scale = {}) {
  return {
      .unit = unit, .scale = scale, .limits = within(0, high), .names = wanted_names<bits, high>};
}

inline constexpr auto no_yes = status_values<2>("No", "Yes");

// Fields.

/// A field with a number.
constexpr std::array<FieldInfo, 1> field(unsigned bits, std::string_view name,
                                         std::string_view description, const ValueInfo& value) {
  return {FieldInfo{.bits = static_cast<std::uint8_t>(bits),
                    .name = name,
                    .value = value,
                    .description = description}};
}
/// A field with named codes; side_by_side() gives its place.
constexpr std::array<FieldInfo, 1> field(unsigned bits, std::string_view name,
                                         std::string_view description, Items<NamedValue> names) {
  return field(bits, name, description, ValueInfo{.names = names});
}
/// Fields of one kind, numbered from `first` upward; `#` in the name stands for the number.
template <std::size_t count>
constexpr std::array<FieldInfo, count> numbered(unsigned bits, std::string_view name,
                                                std::string_view description,
                                                Items<NamedValue> names, unsigned first = 1) {
  return repeat_field<count>({.bits = static_cast<std::uint8_t>(bits),
                              .name = name,
                              .value = {.names = names},
                              .description = description,
                              .number = static_cast<std::uint16_t>(first)});
}

template <unsigned bits>
inline constexpr NamedValue padding[] = {{all_ones(bits), "Reserved", Meaning::padding}};
/// Reserved bits, all of them 1, as the figures show them: `count` fields of `bits` bits.
template <unsigned bits, std::size_t count = 1>
constexpr std::array<FieldInfo, count> reserved() {
  return repeat_field<count>({.bits = bits, .name = "r", .value = {.names = padding<bits>}});
}

/// Fields in their order from bit 0 upward: each begins where the one before it ends.
template <std::size_t... counts>
constexpr auto side_by_side(const std::array<FieldInfo, counts>&... groups) {
  std::array<FieldInfo, (counts + ...)> fields{};
  std::size_t position = 0;
  unsigned bit = 0;
  const auto append = [&](const auto& group) {
    for (const FieldInfo& one : group) {
      fields[position] = one;
      fields[position++].first_bit = static_cast<std::uint8_t>(bit);
      bit += one.bits;
    }
  };
  (append(groups), ...);
  return fields;
}

// Entries and objects.

/// Every bit of an entry is in one of its fields.
constexpr void check_filled(DataType type, const Items<FieldInfo>& fields) {
  unsigned bits = 0;
  for (const FieldInfo& one : fields) bits += one.bits;
  if (bits != bit_length(type)) detail::description_is_wrong("the fields do not fill their entry");
}

/// An entry of a status: ro without a default in its provider, rw in its consumers.
constexpr EntryInfo status(DataType type, Mapping mapping, const ValueInfo& value) {
  return {.type = type,
          .access = Access::ro,
          .consumer_access = Access::rw,
          .mapping = mapping,
          .consumer_initial = all_ones(bit_length(type)),
          .value = value};
}
/// The same, divided into fields, which must fill the type.
constexpr EntryInfo status(DataType type, Mapping mapping, Items<FieldInfo> fields) {
  check_filled(type, fields);
  EntryInfo entry = status(type, mapping, ValueInfo{});
  entry.fields = fields;
  return entry;
}
/// A text that is not known at first. Its default is the manufacturer's.
constexpr EntryInfo status_text(std::uint16_t capacity, bool is_printed = false) {
  return {.type = DataType::utf8_string,
          .access = Access::ro,
          .consumer_access = Access::rw,
          .capacity = capacity,
          .capacity_is_printed = is_printed};
}
/// An entry of a command: rw, "take no action" by default.
constexpr EntryInfo command(DataType type, const ValueInfo& value) {
  return {
      .type = type, .access = Access::rw, .initial = all_ones(bit_length(type)), .value = value};
}
/// The same, divided into fields, which must fill the type.
constexpr EntryInfo command(DataType type, Items<FieldInfo> fields) {
  check_filled(type, fields);
  EntryInfo entry = command(type, ValueInfo{});
  entry.fields = fields;
  return entry;
}

/// An entry of an array or record.
constexpr EntryInfo at(unsigned sub, std::string_view name, EntryInfo entry,
                       Category category = Category::mandatory) {
  entry.sub_first = static_cast<std::uint8_t>(sub);
  entry.name = name;
  entry.category = category;
  return entry;
}
/// Sub-index 00h, from `low` to `high`. A single value is the default; otherwise the device defines
/// it (errata Z19, Z20).
constexpr EntryInfo highest_sub_index(unsigned low, unsigned high, Access access = Access::ro) {
  return {.name = "Highest sub-index supported",
          .access = access,
          .initial = highest_sub(static_cast<std::uint8_t>(low == high ? high : 0)),
          .value = {.limits = within(low, high)}};
}

/// Condition of objects for which part 3 defines no category.
inline constexpr std::string_view as_part_2_says = "as CiA 447-2 says for the virtual device";

/// Remarks that apply to some objects only.
struct Remarks {
  Category category = Category::conditional;  ///< conditional: as defined in part 2
  std::string_view errata = {};               ///< findings that concern it
};
inline constexpr Remarks optional_object = {.category = Category::optional, .errata = "A16"};

/// A variable as part 3 describes it.
constexpr ObjectInfo variable_object(std::uint16_t index, std::string_view name,
                                     std::string_view clause, std::string_view description,
                                     const EntryInfo& entry, const Remarks& remarks = {}) {
  return {.index = index,
          .code = ObjectCode::var,
          .name = name,
          .category = remarks.category,
          .condition = remarks.category == Category::conditional ? as_part_2_says : "",
          .clause = clause,
          .errata = remarks.errata,
          .description = description,
          .entry = entry};
}
/// An array or record as part 3 describes it.
constexpr ObjectInfo structured_object(ObjectCode code, std::uint16_t index, std::string_view name,
                                       std::string_view clause, std::string_view description,
                                       Items<EntryInfo> subs, const Remarks& remarks = {}) {
  ObjectInfo object = variable_object(index, name, clause, description, {}, remarks);
  object.code = code;
  object.subs = subs;
  return object;
}
/// An array as part 3 describes it.
constexpr ObjectInfo array_object(std::uint16_t index, std::string_view name,
                                  std::string_view clause, std::string_view description,
                                  Items<EntryInfo> subs, const Remarks& remarks = {}) {
  return structured_object(ObjectCode::array, index, name, clause, description, subs, remarks);
}

}  // namespace canvoy::cia447
