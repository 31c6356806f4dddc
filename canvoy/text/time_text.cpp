#include "canvoy/text/time_text.hpp"

#include <fmt/format.h>

#include <charconv>

namespace canvoy::text {

namespace {

constexpr std::uint32_t milliseconds_max = 0x0FFF'FFFF;  // 28 bits

std::string clock_text(std::uint32_t milliseconds) {
  const std::uint32_t seconds = milliseconds / 1000;
  return fmt::format("{:02}:{:02}:{:02}.{:03}", seconds / 3600, seconds / 60 % 60, seconds % 60,
                     milliseconds % 1000);
}

/// Reads a text from its start.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool take(std::string_view what) {
    if (!text_.starts_with(what)) return false;
    text_.remove_prefix(what.size());
    return true;
  }
  /// A number without a sign, up to `last`.
  std::optional<std::uint32_t> number(std::uint32_t last) {
    std::uint32_t value = 0;
    const char* const first = text_.data();
    const auto [end, error] = std::from_chars(first, first + text_.size(), value);
    if (error != std::errc{} || value > last) return std::nullopt;
    digits_ = static_cast<std::size_t>(end - first);
    text_.remove_prefix(digits_);
    return value;
  }
  /// Number of digits of the last number.
  std::size_t digits() const { return digits_; }
  bool at_end() const { return text_.empty(); }

 private:
  std::string_view text_;
  std::size_t digits_ = 0;
};

/// The digits after a decimal point, at most three.
std::optional<std::uint32_t> parse_fraction(Scanner& scanner) {
  const auto fraction = scanner.number(999);
  if (!fraction || scanner.digits() > 3) return std::nullopt;
  constexpr std::uint32_t weights[] = {0, 100, 10, 1};
  return *fraction * weights[scanner.digits()];
}

/// `12:00`, `12:00:00`, `12:00:00.25` up to the end of the text, in milliseconds.
std::optional<std::uint32_t> parse_clock(Scanner& scanner, std::uint32_t hours_max) {
  const auto hours = scanner.number(hours_max);
  if (!hours || !scanner.take(":")) return std::nullopt;
  const auto minutes = scanner.number(59);
  if (!minutes) return std::nullopt;
  std::uint32_t milliseconds = (*hours * 60 + *minutes) * 60'000;
  if (scanner.take(":")) {
    const auto seconds = scanner.number(59);
    if (!seconds) return std::nullopt;
    milliseconds += *seconds * 1000;
    if (scanner.take(".")) {
      const auto fraction = parse_fraction(scanner);
      if (!fraction) return std::nullopt;
      milliseconds += *fraction;
    }
  }
  return scanner.at_end() ? std::optional(milliseconds) : std::nullopt;
}

}  // namespace

std::string time_text(const TimeOfDay& time) {
  if (!time.valid()) return fmt::format("day {}, {} ms", time.days, time.milliseconds);
  const std::chrono::year_month_day date(time_of_day_epoch + std::chrono::days(time.days));
  return fmt::format("{:04}-{:02}-{:02} {}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock_text(time.milliseconds));
}

std::string time_text(const TimeDifference& time) {
  return fmt::format("{} d {}", time.days, clock_text(time.milliseconds));
}

std::optional<TimeOfDay> parse_time_of_day(std::string_view text) {
  Scanner scanner(text);
  const auto year = scanner.number(9999);
  if (!year || !scanner.take("-")) return std::nullopt;
  const auto month = scanner.number(12);
  if (!month || !scanner.take("-")) return std::nullopt;
  const auto day = scanner.number(31);
  if (!day || !(scanner.take(" ") || scanner.take("T"))) return std::nullopt;
  const auto milliseconds = parse_clock(scanner, 23);
  const auto date = std::chrono::year(static_cast<int>(*year)) / std::chrono::month(*month) /
                    std::chrono::day(*day);
  if (!milliseconds || !date.ok()) return std::nullopt;
  return to_time_of_day(std::chrono::sys_days(date) + std::chrono::milliseconds(*milliseconds));
}

std::optional<TimeDifference> parse_time_difference(std::string_view text) {
  std::uint32_t days = 0;
  if (const auto separator = text.find(" d "); separator != std::string_view::npos) {
    Scanner scanner(text.substr(0, separator));
    const auto number = scanner.number(0xFFFF);
    if (!number || !scanner.at_end()) return std::nullopt;
    days = *number;
    text.remove_prefix(separator + 3);
  }
  Scanner scanner(text);
  constexpr std::uint32_t hours_max = milliseconds_max / 3'600'000;
  const auto milliseconds = parse_clock(scanner, hours_max);
  if (!milliseconds || *milliseconds > milliseconds_max) return std::nullopt;
  return TimeDifference{.milliseconds = *milliseconds, .days = static_cast<std::uint16_t>(days)};
}

}  // namespace canvoy::text
