#include "canvoy/worlds/taxi/paper_lines.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace canvoy::taxi {

namespace {

bool is_digit(char one) {
  return one >= '0' && one <= '9';
}

std::string_view without_spaces_before(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

}  // namespace

NamedLine named_line(std::string_view line) {
  constexpr std::size_t width = 12;
  const std::string_view name = line.substr(0, width);
  return {name.substr(0, name.find_last_not_of(' ') + 1), line.substr(name.size())};
}

std::optional<double> amount_of(std::string_view text, unsigned decimals, std::string_view behind) {
  text = without_spaces_before(text);
  std::uint64_t units = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), units);
  if (error != std::errc{}) return std::nullopt;
  std::string_view rest = text.substr(static_cast<std::size_t>(stop - text.data()));
  double part = 0;
  if (decimals != 0) {
    const bool has_point = rest.size() > decimals && rest[0] == '.' &&
                           std::ranges::all_of(rest.substr(1, decimals), is_digit);
    if (!has_point) return std::nullopt;
    for (unsigned i = decimals; i >= 1; --i) part = (part + (rest[i] - '0')) / 10;
    rest.remove_prefix(decimals + 1);
  }
  if (rest != behind) return std::nullopt;
  constexpr double thousandths = 1000;
  return std::round((static_cast<double>(units) + part) * thousandths);
}

std::optional<double> sum_of(std::string_view text, const cia447::Currency& currency) {
  const std::string symbol(currency.symbol);
  if (!currency.leads) return amount_of(text, currency.decimals(), " " + symbol);
  if (!text.starts_with(symbol + " ")) return std::nullopt;
  return amount_of(text.substr(symbol.size()), currency.decimals());
}

std::optional<std::int64_t> minute_of(std::string_view text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minutes = 0;
  int end = 0;
  const std::string copy(text);
  const int read = std::sscanf(copy.c_str(), "%4d-%2u-%2u %2d:%2d%n", &year, &month, &day, &hour,
                               &minutes, &end);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (read != 5 || end != static_cast<int>(copy.size()) || !date.ok()) return std::nullopt;
  const auto at =
      std::chrono::sys_days(date) + std::chrono::hours(hour) + std::chrono::minutes(minutes);
  return std::chrono::floor<std::chrono::seconds>(at).time_since_epoch().count();
}

std::optional<double> span_of(std::string_view text) {
  constexpr double an_hour = 3600;
  constexpr double a_minute = 60;
  unsigned hours = 0;
  unsigned minutes = 0;
  unsigned seconds = 0;
  int end = 0;
  const std::string copy(text);
  const int read = std::sscanf(copy.c_str(), "%u:%2u:%2u%n", &hours, &minutes, &seconds, &end);
  if (read != 3 || end != static_cast<int>(copy.size())) return std::nullopt;
  return hours * an_hour + minutes * a_minute + seconds;
}

std::optional<double> count_of(std::string_view text) {
  const std::optional<double> thousandths = amount_of(text, 0);
  return thousandths ? std::optional(*thousandths / 1000) : std::nullopt;
}

bool is_same_amount(double one, double other) {
  constexpr double part = 0.5;  // of a thousandth
  return std::abs(one - other) < part;
}

bool is_minute_at(std::int64_t printed, const TownClock& clock, Time at) {
  constexpr double minute = 60;
  constexpr double clock_seconds = 2;
  const double part_of_second = std::chrono::duration<double>((at - Time{}) % 1s).count();
  const double truth = static_cast<double>(clock.local(at)) + part_of_second;
  const auto begin = static_cast<double>(printed);
  return truth >= begin - clock_seconds && truth < begin + minute + clock_seconds;
}

}  // namespace canvoy::taxi
