#include "canvoy/tools/argument/value_argument.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <ranges>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/argument/unit_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

using formats::trimmed;

const NamedValue* named_value(const ValueInfo& value, std::string_view text) {
  const auto* found = std::ranges::find_if(value.names, [text](const NamedValue& named) {
    return named.meaning != Meaning::reserved && same_name(named.name, text);
  });
  return found == value.names.end() ? nullptr : found;
}

std::string names_of(const ValueInfo& value) {
  std::vector<std::string_view> names;
  for (const NamedValue& named : value.names) {
    if (named.meaning != Meaning::reserved) names.push_back(named.name);
  }
  return names.empty() ? "" : fmt::format(", or one of: {}", fmt::join(names, ", "));
}

/// The number with its sign. A magnitude with all 64 bits is a pattern for 64 bits, else the
/// greatest number, which is out of every range.
std::int64_t with_sign(std::uint64_t magnitude, bool negative, unsigned bits) {
  constexpr std::uint64_t greatest = std::numeric_limits<std::int64_t>::max();
  const bool is_pattern = bits >= 64 && (!negative || magnitude == greatest + 1);
  if (magnitude <= greatest || is_pattern) {
    return static_cast<std::int64_t>(negative ? 0 - magnitude : magnitude);
  }
  return negative ? std::numeric_limits<std::int64_t>::min()
                  : std::numeric_limits<std::int64_t>::max();
}

/// Reads an integer in the notation of programs (`0x1F`, `-3`) or of CiA (`1Fh`).
std::optional<std::int64_t> parse_integer(std::string_view text, unsigned bits) {
  bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  } else if (text.ends_with('h') || text.ends_with('H')) {
    text.remove_suffix(1);
    base = 16;
  }
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  const bool is_too_low = negative && number > std::uint64_t{1} << 63;
  if (bits >= 64 && is_too_low) return std::nullopt;
  return with_sign(number, negative, bits);
}

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [end, error] = real_from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

std::vector<std::uint8_t> number_bytes(std::uint64_t raw, DataType type) {
  std::vector<std::uint8_t> bytes(8);
  store(bytes.data(), raw);
  bytes.resize(byte_length(type));
  return bytes;
}

std::vector<std::uint8_t> real_bytes(const EntryInfo& entry, double number, std::string_view text) {
  // Greater values would become infinite without notice.
  const bool is_short = entry.type == DataType::real32;
  const double greatest =
      is_short ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  if (std::abs(number) > greatest) {
    throw UsageError(fmt::format("{} is out of range: {:g} to {:g}", text, -greatest, greatest));
  }
  if (is_short) {
    return number_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(number)), entry.type);
  }
  return number_bytes(std::bit_cast<std::uint64_t>(number), entry.type);
}

/// The text without the unit of the entry at its end.
std::string_view without_unit(const ValueInfo& value, std::string_view text) {
  const std::string_view unit = symbol(value.unit);
  if (unit.empty() || !text.ends_with(unit)) return text;
  text.remove_suffix(unit.size());
  return trimmed(text);
}

[[noreturn]] void refuse_number(const ValueInfo& value, std::string_view text) {
  const std::string_view unit = symbol(value.unit);
  std::vector<std::string> names;
  for (const NamedValue& named : value.names) names.emplace_back(named.name);
  throw UsageError(fmt::format("'{}' is no value here: give a number{}{}{}", text,
                               unit.empty() ? "" : fmt::format(" in {}", unit), names_of(value),
                               did_you_mean(text, names)));
}

[[noreturn]] void refuse_range(const ValueInfo& value, const BitRange& bits,
                               std::string_view text) {
  const NumberRules rules(value, bits);
  const auto [low, high] = rules.physical_range();
  const unsigned digits = decimals(scale_of(value, rules.range().low));
  const std::string_view unit = symbol(value.unit);
  throw UsageError(fmt::format("{} is out of range: {:.{}f} to {:.{}f}{}{}{}", text, low, digits,
                               high, digits, unit.empty() ? "" : " ", unit, names_of(value)));
}

/// Refuses values that would be rounded, with the nearest possible values.
void check_steps(const ValueInfo& value, const BitRange& bits, double number,
                 std::string_view text) {
  constexpr double tolerance = 1e-9;  // for binary fractions in place of decimal ones
  const NumberRules rules(value, bits);
  const double exact = rules.exact(number);
  const double nearest = std::round(exact);
  if (std::abs(exact - nearest) <= tolerance * std::max(1.0, std::abs(exact))) return;
  std::map<double, std::string> steps;
  for (const double step : {std::floor(exact), std::ceil(exact)}) {
    const auto raw = static_cast<std::int64_t>(step);
    const auto physical = rules.physical(raw);
    if (!physical) continue;
    const unsigned digits = decimals(scale_of(value, raw));
    steps[*physical] = trimmed(fmt::format("{:.{}f} {}", *physical, digits, symbol(value.unit)));
  }
  if (steps.empty()) refuse_range(value, bits, text);
  throw UsageError(fmt::format("'{}' cannot be stored exactly: {} can", text,
                               fmt::join(std::views::values(steps), " or ")));
}

std::uint64_t parse_plain(const ValueInfo& value, const BitRange& bits, std::string_view text) {
  const auto integer = parse_integer(text, bits.bits);
  if (!integer) {
    if (const auto number = parse_number(text)) check_steps(value, bits, *number, text);
    refuse_number(value, text);
  }
  if (!NumberRules(value, bits).range().contains(*integer) && bits.bits < 64) {
    refuse_range(value, bits, text);
  }
  return static_cast<std::uint64_t>(*integer);
}

/// `0x1F4` is the stored number, without a scale.
std::optional<std::uint64_t> parse_stored(const ValueInfo& value, const BitRange& bits,
                                          std::string_view text) {
  if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
  const auto integer = parse_integer(text, bits.bits);
  if (!integer) return std::nullopt;
  const bool fits = bits.bits >= 64 || (*integer >= 0 && *integer >> bits.bits == 0);
  if (!fits) refuse_range(value, bits, text);
  return static_cast<std::uint64_t>(*integer);
}

std::uint64_t parse_raw(const ValueInfo& value, const BitRange& bits, std::string_view text) {
  if (const NamedValue* named = named_value(value, text)) {
    return static_cast<std::uint64_t>(named->first);
  }
  if (value.scale == Scale{} && value.unit == Unit::none && value.pieces.empty()) {
    return parse_plain(value, bits, text);
  }
  if (const auto stored = parse_stored(value, bits, text)) return *stored;
  const auto number = parse_amount(value, text);
  if (!number) refuse_number(value, text);
  const canvoy::Result<std::uint64_t> raw = raw_from_physical(value, bits, *number);
  if (!raw) refuse_range(value, bits, text);
  check_steps(value, bits, *number, text);
  return *raw;
}

/// The field with this name; throws if there is none.
const FieldInfo& named_field(const EntryInfo& entry, std::string_view name) {
  std::vector<std::string> names;
  for (const FieldInfo& field : entry.fields) {
    if (same_name(formats::field_name(field), name)) return field;
    names.push_back(formats::field_name(field));
  }
  throw UsageError(fmt::format("'{}' is no field here: {}{}", name, fmt::join(names, ", "),
                               did_you_mean(name, names)));
}

/// `readiness: ready, lamp 2: on`, as printed; fields that are not named keep their value.
std::uint64_t parse_fields(const EntryInfo& entry, std::string_view text, std::uint64_t present) {
  while (!text.empty()) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
      throw UsageError(
          fmt::format("'{}' is no value here: write FIELD: VALUE, FIELD: VALUE", text));
    }
    const std::string_view rest = text.substr(colon + 1);
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const FieldInfo& field = named_field(entry, trimmed(text.substr(0, colon)));
    const auto raw = parse_raw(field.value, bits_of(field), trimmed(rest.substr(0, comma)));
    present = insert(present, bits_of(field), static_cast<std::int64_t>(raw));
    text = trimmed(rest.substr(std::min(comma + 1, rest.size())));
  }
  return present;
}

std::vector<std::uint8_t> parse_hex(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  std::string digits;
  std::ranges::copy_if(text, std::back_inserter(digits), [](char c) { return c != ' '; });
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    std::uint8_t byte = 0;
    const char* first = digits.data() + i;
    const char* last = digits.data() + std::min(i + 2, digits.size());
    const auto [end, error] = std::from_chars(first, last, byte, 16);
    if (error != std::errc{} || end != last || last - first != 2) {
      throw UsageError(fmt::format("'{}' is no value: write bytes as hex:01 02 AB", text));
    }
    bytes.push_back(byte);
  }
  return bytes;
}

/// A text may be quoted, as printed.
std::string_view without_quotes(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

bool is_time(const EntryInfo& entry) {
  return entry.type == DataType::time_of_day || entry.type == DataType::time_difference;
}

std::vector<std::uint8_t> parse_time(DataType type, std::string_view text) {
  const auto bytes_of = [](const auto& time) {
    const TimeOfDayBytes bytes = encode_time(time);
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  };
  if (type == DataType::time_of_day) {
    if (const auto time = text::parse_time_of_day(text)) return bytes_of(*time);
    throw UsageError(fmt::format("'{}' is no time: write 2026-11-21 12:00:00", text));
  }
  if (const auto time = text::parse_time_difference(text)) return bytes_of(*time);
  throw UsageError(fmt::format("'{}' is no time: write 3 d 12:00:00, or 12:00:00", text));
}

}  // namespace

std::optional<double> parse_amount(const ValueInfo& value, std::string_view text) {
  if (const auto number = parse_number(without_unit(value, text))) return number;
  if (const auto duration = parse_duration(text)) {
    const auto units = conversion(Unit::microsecond, value.unit);
    if (units) return static_cast<double>(duration->count()) * *units;
  }
  std::size_t end = text.size();
  while (end > 0 && !parse_number(trimmed(text.substr(0, end)))) --end;
  const auto number = parse_number(trimmed(text.substr(0, end)));
  const auto unit = find_filter_unit(trimmed(text.substr(end)));
  const auto units = unit ? conversion(unit->unit, value.unit) : std::nullopt;
  if (!number || !units) return std::nullopt;
  return *number * unit->count * *units;
}

std::vector<std::uint8_t> parse_value(const EntryInfo& entry, std::string_view text,
                                      std::uint64_t present) {
  constexpr std::string_view hex_prefix = "hex:";
  if (text.starts_with(hex_prefix)) return parse_hex(text.substr(hex_prefix.size()));
  if (is_string(entry.type) || entry.type == DataType::domain) {
    text = without_quotes(text);
    return {text.begin(), text.end()};
  }
  const std::string_view word = trimmed(text);
  if (is_real(entry.type)) {
    const auto number = parse_amount(entry.value, word);
    if (!number) refuse_number(entry.value, word);
    return real_bytes(entry, to_raw(*number, entry.value.scale), word);
  }
  if (is_time(entry)) return parse_time(entry.type, word);
  if (!is_integer(entry.type)) {
    throw UsageError("a value of this type is written as bytes: hex:01 02 AB");
  }
  const FieldInfo* only = only_field(entry);
  if (only == nullptr && !entry.fields.empty() && word.find(':') != std::string_view::npos) {
    return number_bytes(parse_fields(entry, word, present), entry.type);
  }
  const ValueInfo& value = only != nullptr ? only->value : entry.value;
  const BitRange bits = only != nullptr ? bits_of(*only) : bits_of(entry);
  const std::uint64_t raw = parse_raw(value, bits, word);
  return number_bytes(insert(0, bits, static_cast<std::int64_t>(raw)), entry.type);
}

std::optional<DataType> parse_type(std::string_view text) {
  struct TypeName {
    std::string_view name;
    DataType type;
  };
  using enum DataType;
  static constexpr auto names = std::to_array<TypeName>({
      {"b", boolean},
      {"i8", integer8},
      {"i16", integer16},
      {"i24", integer24},
      {"i32", integer32},
      {"i40", integer40},
      {"i48", integer48},
      {"i56", integer56},
      {"i64", integer64},
      {"u8", unsigned8},
      {"u16", unsigned16},
      {"u24", unsigned24},
      {"u32", unsigned32},
      {"u40", unsigned40},
      {"u48", unsigned48},
      {"u56", unsigned56},
      {"u64", unsigned64},
      {"r32", real32},
      {"r64", real64},
      {"vs", visible_string},
      {"os", octet_string},
      {"us", unicode_string},
      {"d", domain},
      {"t", time_of_day},
      {"td", time_difference},
      {"bool", boolean},
      {"float", real32},
      {"double", real64},
      {"string", visible_string},
      {"str", visible_string},
      {"visiblestring", visible_string},
      {"octetstring", octet_string},
      {"unicodestring", unicode_string},
      {"domain", domain},
      {"boolean", boolean},
  });
  // As CiA 301, C and Python spell them: UNSIGNED16, INTEGER16, REAL32, uint16_t, int16.
  static constexpr auto kinds = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"unsigned", "u"}, {"uint", "u"}, {"integer", "i"}, {"int", "i"}, {"real", "r"}});
  std::string plain;
  for (const char c : text.substr(0, text.ends_with("_t") ? text.size() - 2 : text.size())) {
    if (c != '_') plain += in_lower_case(c);
  }
  for (const auto& [kind, letter] : kinds) {
    if (plain.starts_with(kind)) plain.replace(0, kind.size(), letter);
  }
  const auto* found = std::ranges::find(names, plain, &TypeName::name);
  return found == names.end() ? std::nullopt : std::optional(found->type);
}

DataType parse_type_argument(std::string_view text) {
  if (const auto type = parse_type(text)) return *type;
  throw UsageError(fmt::format(
      "'{}' is no data type: b, i8 to i64, u8 to u64, r32, r64, t, td, vs, os, us, d", text));
}

}  // namespace canvoy::tools
