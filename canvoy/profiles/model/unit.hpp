// Physical units of the profiles, exact scales, and amounts with a unit in their type.
//
//     Amount<Unit::volt> battery = 24.0;
//     constexpr Scale eighth_degrees = {.denominator = 8};  // 0.125 degrees a bit
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace canvoy {

/// Unit of a number that counts or measures.
enum class Unit : std::uint8_t {
  none,
  percent,
  per_mille,
  degree_celsius,
  volt,
  ampere,
  ampere_hour,
  watt,
  watt_hour,
  ohm,
  hertz,
  microsecond,
  hundred_microseconds,  ///< the unit of inhibit times in CiA 301
  millisecond,
  second,
  minute,
  hour,
  day,
  millimetre,
  centimetre,
  metre,
  kilometre,
  metre_per_second,
  kilometre_per_hour,
  metre_per_second_squared,
  degree,
  radian,
  revolution_per_minute,
  litre,
  litre_per_hour,
  litre_per_100_kilometres,
  kilometre_per_litre,
  gram,
  kilogram,
  newton,
  newton_metre,
  pascal,
  bar,
  lux,
  bit_per_second,
  micrometre,
  millimetre_per_second,
  millimetre_per_second_squared,
  line_per_second,  ///< of scrolling text: a seventh of a character's height each (CiA 417-4)
  per_second,       ///< events
  local_currency,   ///< CiA 447: of the country of the taximeter
  local_currency_per_hour,      ///< CiA 447
  local_currency_per_distance,  ///< CiA 447: for each local unit of distance
  local_distance,               ///< CiA 447: kilometres or miles, as shown by the car
  local_distance_per_hour,      ///< CiA 447
  pulse_per_local_distance,     ///< CiA 447
  fuel_unit_per_second,         ///< CiA 447: litres or kilograms; another field says which
  pixel,
  year,   ///< of the calendar
  month,  ///< of the calendar
};

inline constexpr unsigned unit_count = static_cast<unsigned>(Unit::month) + 1;  ///< `none` included

namespace detail {

inline constexpr std::array<std::string_view, unit_count> unit_symbols = {
    "",         "%",     "‰",       "°C",      "V",    "A",   "Ah",    "W",       "Wh",  "Ω",
    "Hz",       "µs",    "×100 µs", "ms",      "s",    "min", "h",     "d",       "mm",  "cm",
    "m",        "km",    "m/s",     "km/h",    "m/s²", "°",   "rad",   "1/min",   "l",   "l/h",
    "l/100 km", "km/l",  "g",       "kg",      "N",    "Nm",  "Pa",    "bar",     "lx",  "bit/s",
    "µm",       "mm/s",  "mm/s²",   "lines/s", "1/s",  "LCU", "LCU/h", "LCU/LDU", "LDU", "LDU/h",
    "1/LDU",    "FSU/s", "px",      "year",    "month"};

}  // namespace detail

/// Text of the unit behind a number; empty for none.
constexpr std::string_view symbol(Unit unit) {
  return detail::unit_symbols[static_cast<unsigned>(unit)];
}

/// Exact conversion of a raw number to a physical one:
/// physical = (raw x numerator + offset) / denominator.
struct Scale {
  std::int64_t numerator = 1;    ///< not 0
  std::int64_t denominator = 1;  ///< greater than 0
  std::int64_t offset = 0;       ///< added before the division

  friend constexpr bool operator==(const Scale&, const Scale&) = default;
};

/// The physical value of a raw number; the arithmetic is exact up to 2^53.
constexpr double to_physical(double raw, const Scale& scale) {
  return (raw * static_cast<double>(scale.numerator) + static_cast<double>(scale.offset)) /
         static_cast<double>(scale.denominator);
}
/// The inverse, not rounded.
constexpr double to_raw(double physical, const Scale& scale) {
  return (physical * static_cast<double>(scale.denominator) - static_cast<double>(scale.offset)) /
         static_cast<double>(scale.numerator);
}

/// Number of decimals to show: the exact number up to three, otherwise as many as distinguish each
/// step from the next (9 at most).
constexpr unsigned decimals(const Scale& scale) {
  const std::int64_t step = scale.numerator < 0 ? -scale.numerator : scale.numerator;
  constexpr unsigned exact_max = 3;
  std::int64_t power = 1;
  for (unsigned digits = 0; digits <= exact_max; ++digits, power *= 10) {
    if (power * step % scale.denominator == 0) return digits;
  }
  unsigned digits = 0;
  for (power = 1; digits < 9 && power * step < scale.denominator; power *= 10) ++digits;
  return digits;
}

/// A number with its unit in its type, for signatures in which units could be confused. Conversion
/// to a plain number loses the unit.
template <Unit unit_>
class Amount {
 public:
  static constexpr Unit unit = unit_;  ///< in its type

  constexpr Amount() = default;
  /// A plain number is in this unit.
  constexpr Amount(double number) : number_(number) {}  // NOLINT(google-explicit-constructor)
  /// Refused: another unit.
  template <Unit other>
    requires(other != unit_)
  Amount(Amount<other>) = delete;

  /// The number in this unit.
  constexpr double number() const { return number_; }
  friend constexpr auto operator<=>(Amount, Amount) = default;

 private:
  double number_ = 0;
};

using Celsius = Amount<Unit::degree_celsius>;   ///< temperature
using Volts = Amount<Unit::volt>;               ///< voltage
using Amperes = Amount<Unit::ampere>;           ///< current
using AmpereHours = Amount<Unit::ampere_hour>;  ///< charge
using Percent = Amount<Unit::percent>;          ///< 0 to 100 for a share

}  // namespace canvoy
