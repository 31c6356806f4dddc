// From raw numbers to physical values and back, for any described value: typed handles use it at
// compile time, tools at run time. Nothing here makes text or takes memory.
//
//     const Reading reading = read_value(object.entry, bytes);
//     if (reading.kind == Reading::Kind::number) show(reading.number, reading.value->unit);
//     Result<std::uint64_t> raw = raw_from_physical(object.entry.value, 16, true, 21.5);
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "canvoy/canopen/abort_code.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy {

/// Bits of an entry that hold one number.
struct BitRange {
  std::uint8_t first = 0;
  std::uint8_t bits = 8;
  bool is_signed = false;

  friend constexpr bool operator==(const BitRange&, const BitRange&) = default;
};
constexpr BitRange bits_of(const EntryInfo& entry) {
  return {0, static_cast<std::uint8_t>(bit_length(entry.type)), is_signed(entry.type)};
}
constexpr BitRange bits_of(const FieldInfo& field) {
  return {field.first_bit, field.bits, field.is_signed};
}

/// The number in some bits of an entry's value.
constexpr std::int64_t extract(std::uint64_t whole, const BitRange& range) {
  return number_of(whole >> range.first, range.bits, range.is_signed);
}
/// The entry's value with a number put into some of its bits.
constexpr std::uint64_t insert(std::uint64_t whole, const BitRange& range, std::int64_t number) {
  const std::uint64_t ones = range.bits >= 64 ? ~std::uint64_t{0} : (1ULL << range.bits) - 1;
  const std::uint64_t shifted = (static_cast<std::uint64_t>(number) & ones) << range.first;
  return (whole & ~(ones << range.first)) | shifted;
}

/// The lowest and highest number that may be sent. Of 64 unsigned bits, 63 are used.
struct NumberRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
constexpr NumberRange range_of_type(unsigned bits, bool is_signed) {
  constexpr std::int64_t top = std::numeric_limits<std::int64_t>::max();
  if (is_signed) return {-(top >> (64 - bits)) - 1, top >> (64 - bits)};
  return {0, bits >= 63 ? top : static_cast<std::int64_t>((1ULL << bits) - 1)};
}
constexpr NumberRange range_of(const ValueInfo& value, const BitRange& bits) {
  if (value.limits.kind == Limits::Kind::absolute) return {value.limits.low, value.limits.high};
  return range_of_type(bits.bits, bits.is_signed);
}

/// Whether a number stands for no value: a sentinel, a reserved code, out of the limits.
constexpr bool is_no_value(const ValueInfo& value, const BitRange& bits, std::int64_t number) {
  const NamedValue* named = find_name(value, number, bits.bits, bits.is_signed);
  if (named != nullptr) return named->meaning != Meaning::state;
  const NumberRange range = range_of(value, bits);
  return value.limits.kind == Limits::Kind::absolute && (number < range.low || number > range.high);
}

/// The physical value, or nothing where the number stands for no value.
constexpr std::optional<double> physical_from_number(const ValueInfo& value, const BitRange& bits,
                                                     std::int64_t number) {
  if (is_no_value(value, bits, number)) return std::nullopt;
  return to_physical(static_cast<double>(number), value.scale);
}

namespace detail {

constexpr std::int64_t round_into(double exact, const NumberRange& range) {
  if (exact <= static_cast<double>(range.low)) return range.low;
  if (exact >= static_cast<double>(range.high)) return range.high;
  return exact < 0 ? -static_cast<std::int64_t>(0.5 - exact)
                   : static_cast<std::int64_t>(exact + 0.5);
}

/// The nearest number from `number` in direction `step` that stands for a value, or nothing.
constexpr std::optional<std::int64_t> next_value(const ValueInfo& value, const BitRange& bits,
                                                 std::int64_t number, int step) {
  const NumberRange range = range_of(value, bits);
  while (number >= range.low && number <= range.high) {
    const NamedValue* named = find_name(value, number, bits.bits, bits.is_signed);
    if (named == nullptr || named->meaning == Meaning::state) return number;
    const std::int64_t bound = step < 0 ? named->first : named->last;
    number = number_of(static_cast<std::uint64_t>(bound), bits.bits, bits.is_signed);
    if (number == (step < 0 ? range.low : range.high)) break;
    number += step;
  }
  return std::nullopt;
}

constexpr double distance(double a, std::int64_t b) {
  const double difference = a - static_cast<double>(b);
  return difference < 0 ? -difference : difference;
}

}  // namespace detail

/// The number that comes nearest to a physical value. Beyond the limits it is the limit; a number
/// that stands for no value is passed over to the nearest that does, of two equally near ones that
/// nearer to 0 (CiA 419, errata 1: 0 or -2, not -1). Not a number gives the sentinel "invalid", and
/// the lower limit where there is none.
constexpr std::int64_t nearest_number(const ValueInfo& value, const BitRange& bits,
                                      double physical) {
  const NumberRange range = range_of(value, bits);
  const bool not_a_number = !(physical == physical);
  if (not_a_number) {
    const NamedValue* invalid = find_invalid(value);
    return invalid != nullptr ? invalid->first : range.low;
  }
  const double exact = to_raw(physical, value.scale);
  const std::int64_t rounded = detail::round_into(exact, range);
  if (value.names.empty()) return rounded;
  const auto below = detail::next_value(value, bits, rounded, -1);
  const auto above = detail::next_value(value, bits, rounded, +1);
  if (!below || !above) return below ? *below : above.value_or(rounded);
  const double down = detail::distance(exact, *below);
  const double up = detail::distance(exact, *above);
  if (down != up) return down < up ? *below : *above;
  return detail::distance(0, *below) < detail::distance(0, *above) ? *below : *above;
}

/// The same with refusal in place of repair, for people who typed a value. Aborts: value_too_low,
/// value_too_high; value_range where the number would stand for no value.
Result<std::uint64_t> raw_from_physical(const ValueInfo& value, const BitRange& bits,
                                        double physical);

/// What an entry or a field of it says.
struct Reading {
  enum class Kind : std::uint8_t {
    none,    ///< of this length there is no value of this type
    number,  ///< `number`, in the unit of `value`
    name,    ///< `named`: a state, or why there is no number
    text,    ///< `text`
    bytes,   ///< octets, a domain, a point in time: to be shown as they are
  };
  Kind kind = Kind::none;
  const ValueInfo* value = nullptr;
  const NamedValue* named = nullptr;
  double number = 0;
  std::int64_t raw = 0;
  bool out_of_range = false;  ///< beyond limits that are absolute
  std::string_view text = {};
};
/// The whole entry. Of bytes that live as long as they do.
Reading read_value(const EntryInfo& entry, std::span<const std::uint8_t> bytes);
/// One field of it.
Reading read_field(const EntryInfo& entry, const FieldInfo& field,
                   std::span<const std::uint8_t> bytes);

}  // namespace canvoy
