#include "canvoy/sim/duration_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace canvoy {

namespace {

struct Suffix {
  std::string_view name;
  std::int64_t microseconds;
};
constexpr std::array units{Suffix{"us", 1}, Suffix{"ms", 1'000}, Suffix{"s", 1'000'000},
                           Suffix{"min", 60'000'000}, Suffix{"h", 3'600'000'000}};

constexpr std::int64_t duration_max = std::int64_t{100} * 365 * 24 * 3'600'000'000;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Other spellings; `m` is none, since it may be a minute or a thousandth.
constexpr std::array other_units{Suffix{"usec", 1},
                                 Suffix{"msec", 1'000},
                                 Suffix{"sec", 1'000'000},
                                 Suffix{"secs", 1'000'000},
                                 Suffix{"second", 1'000'000},
                                 Suffix{"seconds", 1'000'000},
                                 Suffix{"mins", 60'000'000},
                                 Suffix{"minute", 60'000'000},
                                 Suffix{"minutes", 60'000'000},
                                 Suffix{"hour", 3'600'000'000},
                                 Suffix{"hours", 3'600'000'000}};

std::int64_t unit_of(std::string_view name) {
  for (const std::span<const Suffix> known :
       {std::span<const Suffix>(units), std::span<const Suffix>(other_units)}) {
    const auto unit = std::ranges::find(known, name, &Suffix::name);
    if (unit != known.end()) return unit->microseconds;
  }
  return 0;
}

/// A number and its unit, removed from the text.
struct DurationPart {
  Duration duration{};
  std::int64_t unit = 0;
};

std::string_view take_digits(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

std::optional<DurationPart> take_part(std::string_view& text) {
  const std::string_view whole = take_digits(text);
  std::string_view fraction;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    fraction = take_digits(text);
    if (fraction.empty()) return std::nullopt;
  }
  if (text.starts_with(' ')) text.remove_prefix(1);
  std::size_t end = 0;
  while (end < text.size() && !is_digit(text[end]) && text[end] != ' ') ++end;
  const std::int64_t unit = unit_of(text.substr(0, end));
  if (whole.empty() || unit == 0) return std::nullopt;
  text.remove_prefix(end);

  std::int64_t count = 0;
  for (const char c : whole) {
    count = count * 10 + (c - '0');
    if (count > duration_max / unit) return std::nullopt;
  }
  // Digits beyond the ninth are less than a microsecond in any unit.
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  for (const char c : fraction.substr(0, 9)) {
    numerator = numerator * 10 + (c - '0');
    denominator *= 10;
  }
  return DurationPart{Duration(count * unit + numerator * unit / denominator), unit};
}

}  // namespace

std::optional<Duration> parse_duration(std::string_view text) {
  Duration sum{};
  std::int64_t last_unit = duration_max;
  while (true) {
    const std::optional<DurationPart> part = take_part(text);
    if (!part || part->unit >= last_unit) return std::nullopt;
    sum += part->duration;
    last_unit = part->unit;
    if (sum.count() > duration_max) return std::nullopt;
    if (text.empty()) return sum;
    if (text.front() == ' ') text.remove_prefix(1);
  }
}

std::string written(Duration duration) {
  if (duration == Duration{}) return "0s";
  const Suffix* exact = &units.front();
  for (const Suffix& unit : units) {
    if (duration.count() % unit.microseconds == 0) exact = &unit;
  }
  return std::to_string(duration.count() / exact->microseconds) + std::string(exact->name);
}

}  // namespace canvoy
