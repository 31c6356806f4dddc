#include "canvoy/tools/argument/unit_argument.hpp"

#include <array>

#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

struct UnitWord {
  std::string_view word;
  FilterUnit unit;
};

constexpr auto unit_words = std::to_array<UnitWord>({
    {"degC", {Unit::degree_celsius}},
    {"C", {Unit::degree_celsius}},
    {"percent", {Unit::percent}},
    {"mV", {Unit::volt, 1e-3}},
    {"kV", {Unit::volt, 1e3}},
    {"mA", {Unit::ampere, 1e-3}},
    {"kA", {Unit::ampere, 1e3}},
    {"mAh", {Unit::ampere_hour, 1e-3}},
    {"kW", {Unit::watt, 1e3}},
    {"kWh", {Unit::watt_hour, 1e3}},
    {"ohm", {Unit::ohm}},
    {"mohm", {Unit::ohm, 1e-3}},
    {"kohm", {Unit::ohm, 1e3}},
    {"kHz", {Unit::hertz, 1e3}},
    {"us", {Unit::microsecond}},
    {"um", {Unit::micrometre}},
    {"mm/s2", {Unit::millimetre_per_second_squared}},
    {"m/s2", {Unit::metre_per_second_squared}},
    {"deg", {Unit::degree}},
    {"rpm", {Unit::revolution_per_minute}},
    {"ml", {Unit::litre, 1e-3}},
    {"t", {Unit::kilogram, 1e3}},
    {"kN", {Unit::newton, 1e3}},
    {"kPa", {Unit::pascal, 1e3}},
    {"hPa", {Unit::pascal, 1e2}},
    {"mbar", {Unit::bar, 1e-3}},
    {"kbit/s", {Unit::bit_per_second, 1e3}},
});

enum class Dimension : std::uint8_t {
  other,  ///< only the same unit is compatible
  ratio,
  time,
  length,
  speed,
  acceleration,
  angle,
  mass,
  pressure,
};

struct Measure {
  Unit unit;
  Dimension dimension;
  double size;  ///< in a common unit of the dimension
};

constexpr double half_turn = 3.14159265358979323846;

constexpr auto measures = std::to_array<Measure>({
    {Unit::percent, Dimension::ratio, 10},
    {Unit::per_mille, Dimension::ratio, 1},
    {Unit::microsecond, Dimension::time, 1},
    {Unit::hundred_microseconds, Dimension::time, 100},
    {Unit::millisecond, Dimension::time, 1e3},
    {Unit::second, Dimension::time, 1e6},
    {Unit::minute, Dimension::time, 60e6},
    {Unit::hour, Dimension::time, 3600e6},
    {Unit::day, Dimension::time, 86400e6},
    {Unit::micrometre, Dimension::length, 1},
    {Unit::millimetre, Dimension::length, 1e3},
    {Unit::centimetre, Dimension::length, 1e4},
    {Unit::metre, Dimension::length, 1e6},
    {Unit::kilometre, Dimension::length, 1e9},
    {Unit::millimetre_per_second, Dimension::speed, 3.6},
    {Unit::metre_per_second, Dimension::speed, 3600},
    {Unit::kilometre_per_hour, Dimension::speed, 1000},
    {Unit::millimetre_per_second_squared, Dimension::acceleration, 1},
    {Unit::metre_per_second_squared, Dimension::acceleration, 1e3},
    {Unit::degree, Dimension::angle, 1},
    {Unit::radian, Dimension::angle, 180 / half_turn},
    {Unit::gram, Dimension::mass, 1},
    {Unit::kilogram, Dimension::mass, 1e3},
    {Unit::pascal, Dimension::pressure, 1},
    {Unit::bar, Dimension::pressure, 1e5},
});

Measure measure_of(Unit unit) {
  for (const Measure& measure : measures) {
    if (measure.unit == unit) return measure;
  }
  return {unit, Dimension::other, 1};
}

bool is_same_but_for_case(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (in_lower_case(a[i]) != in_lower_case(b[i])) return false;
  }
  return true;
}

template <class IsSame>
std::optional<FilterUnit> find_unit(std::string_view text, const IsSame& is_same) {
  for (unsigned i = 1; i < unit_count; ++i) {
    if (is_same(symbol(static_cast<Unit>(i)), text)) return FilterUnit{static_cast<Unit>(i), 1};
  }
  for (const UnitWord& word : unit_words) {
    if (is_same(word.word, text)) return word.unit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FilterUnit> find_filter_unit(std::string_view text) {
  const auto exactly = [](std::string_view a, std::string_view b) { return a == b; };
  if (const auto unit = find_unit(text, exactly)) return unit;
  return find_unit(text, is_same_but_for_case);
}

std::vector<std::string> filter_unit_names() {
  std::vector<std::string> names;
  names.reserve(std::size(unit_words) + unit_count);
  for (const UnitWord& word : unit_words) names.emplace_back(word.word);
  for (unsigned i = 1; i < unit_count; ++i) names.emplace_back(symbol(static_cast<Unit>(i)));
  return names;
}

std::optional<double> conversion(Unit from, Unit to) {
  if (from == to) return 1;
  const Measure a = measure_of(from);
  const Measure b = measure_of(to);
  if (a.dimension != b.dimension || a.dimension == Dimension::other) return std::nullopt;
  return a.size / b.size;
}

}  // namespace canvoy::tools
