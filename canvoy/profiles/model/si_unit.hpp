// Codes of physical units and of their prefixes (CiA 303-2), for entries that hold the unit of
// others (ValueInfo::unit_entry).
//
//     measure_of(0x22, 0x03)  // 1000 pascals
//     with_measure(entry.value, *measure_of(0x22, 0x03))
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// Size of one count.
struct Measure {
  Unit unit = Unit::none;  ///< of CiA 303-2
  Scale scale = {};        ///< from counts to the unit

  friend constexpr bool operator==(const Measure&, const Measure&) = default;
};

namespace detail {

struct CodedUnit {
  std::uint8_t code = 0;
  Unit unit = Unit::none;
};
/// Units for which profiles have a name.
inline constexpr std::array<CodedUnit, 17> coded_units = {{{0x01, Unit::metre},
                                                           {0x02, Unit::kilogram},
                                                           {0x03, Unit::second},
                                                           {0x04, Unit::ampere},
                                                           {0x10, Unit::radian},
                                                           {0x20, Unit::hertz},
                                                           {0x21, Unit::newton},
                                                           {0x22, Unit::pascal},
                                                           {0x24, Unit::watt},
                                                           {0x26, Unit::volt},
                                                           {0x28, Unit::ohm},
                                                           {0x2D, Unit::degree_celsius},
                                                           {0x2F, Unit::lux},
                                                           {0x41, Unit::degree},
                                                           {0x44, Unit::litre},
                                                           {0x47, Unit::minute},
                                                           {0x4E, Unit::bar}}};

}  // namespace detail

/// By the code of the unit and that of the prefix, which is a signed power of ten. Nothing if one
/// of them is not known here. Prefixes below a billionth and above a billion are not supported.
constexpr std::optional<Measure> measure_of(std::uint8_t unit, std::uint8_t prefix) {
  constexpr int exponent_max = 9;
  const int exponent = prefix < 0x80 ? prefix : prefix - 0x100;
  if (exponent < -exponent_max || exponent > exponent_max) return std::nullopt;
  for (const detail::CodedUnit& each : detail::coded_units) {
    if (each.code != unit) continue;
    Measure measure{.unit = each.unit};
    for (int i = 0; i < exponent; ++i) measure.scale.numerator *= 10;
    for (int i = 0; i > exponent; --i) measure.scale.denominator *= 10;
    return measure;
  }
  return std::nullopt;
}
/// By the contents of an entry that holds a unit.
constexpr std::optional<Measure> measure_of(const UnitEntry& place, std::uint64_t held) {
  const std::uint64_t codes = held >> place.first_bit;
  return measure_of(static_cast<std::uint8_t>(codes), static_cast<std::uint8_t>(codes >> 8));
}

/// Makes a value of which one count is as much as `measure` says of one unit of its own.
constexpr ValueInfo with_measure(ValueInfo value, const Measure& measure) {
  value.unit = measure.unit;
  Scale& scale = value.scale;
  scale.numerator *= measure.scale.numerator;
  scale.offset *= measure.scale.numerator;
  scale.denominator *= measure.scale.denominator;
  const std::int64_t common = std::gcd(std::gcd(scale.numerator, scale.offset), scale.denominator);
  scale.numerator /= common;
  scale.offset /= common;
  scale.denominator /= common;
  return value;
}

}  // namespace canvoy
