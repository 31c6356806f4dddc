#include "canvoy/text/json_number.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace canvoy::text {

namespace {

constexpr unsigned places_max = 15;
constexpr auto powers = [] {
  std::array<std::int64_t, places_max + 1> made{};
  made[0] = 1;
  for (unsigned i = 1; i <= places_max; ++i) made[i] = made[i - 1] * 10;
  return made;
}();

/// The longest number is `-2.2250738585072014e-308`.
constexpr std::size_t number_length = 64;

/// True if the library writes `exact` / `power`, rounded to the double `number`, with these digits.
/// It searches for the shortest digits (Grisu2) within half a step between doubles around the
/// number, except for a 500th of it, of which it cannot be sure. If the fraction is one of them,
/// and steps are smaller than those of the last digit, no other one is as short.
bool is_shortest(double number, double exact, double power) {
  constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;
  constexpr std::uint64_t mantissa_bits = 0x000F'FFFF'FFFF'FFFF;
  constexpr double step_of_one = 0x1p-52;
  constexpr double sure_of = 0.48;
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const double step = std::bit_cast<double>(bits & exponent_bits) * step_of_one;
  const double error = std::fma(number, power, -exact);
  // Below a power of two, steps are half as large.
  const bool is_even = (bits & mantissa_bits) != 0 || error == 0;
  return is_even && std::abs(error) <= sure_of * step * power && step * power < 0.5;
}

/// Writes a decimal point, without trailing zeros; all of `digits` precede it.
void append_fixed(std::string& line, std::uint64_t size, unsigned places) {
  std::array<char, number_length> text{};
  const auto power = static_cast<std::uint64_t>(powers.at(places));
  char* at = std::to_chars(text.data(), text.data() + text.size(), size / power).ptr;
  *at++ = '.';
  std::uint64_t rest = size % power;
  do {
    rest *= 10;
    *at++ = static_cast<char>('0' + rest / power);
    rest %= power;
  } while (rest != 0);
  line.append(text.data(), at);
}

}  // namespace

void append_json_number(std::string& line, double number) {
  // Its digits differ in some cases from those of std::to_chars(), which finds shorter ones.
  std::array<char, number_length> digits{};
  char* const first = digits.data();
  line.append(first, nlohmann::detail::to_chars(first, first + digits.size(), number));
}

void append_json_decimal(std::string& line, std::int64_t number, unsigned places) {
  constexpr std::int64_t exact_max = std::int64_t{1} << 53;
  // Beyond this range, the library writes an exponent.
  constexpr double fixed_min = 1e-4;
  constexpr double fixed_max = 1e15;
  const std::int64_t size = number < 0 ? -number : number;
  const double power = static_cast<double>(powers.at(places));
  const double value = static_cast<double>(size) / power;
  const bool is_fixed = size < exact_max && value >= fixed_min && value < fixed_max;
  if (!is_fixed || !is_shortest(value, static_cast<double>(size), power)) {
    return append_json_number(line, static_cast<double>(number) / power);
  }
  if (number < 0) line += '-';
  append_fixed(line, static_cast<std::uint64_t>(size), places);
}

}  // namespace canvoy::text
