#include "canvoy/sim/taxi/read_receipts.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

namespace canvoy::taxi {

namespace {

/// A receipt has minutes, and a meter's clock seconds.
constexpr std::int64_t minute = 60;
constexpr double clock_seconds = 2;
/// It has hundredths of a kilometre.
constexpr double printed_step = 10;
constexpr double same_amount = 0.5;  ///< in 0,001 of the currency unit

/// What is read: amounts in thousandths, times in seconds since 1970-01-01.
struct Printed {
  std::size_t number = 0;
  std::optional<std::int64_t> from;
  std::optional<std::int64_t> to;
  std::optional<double> metres;
  std::optional<double> fare;
  double extras = 0;
  std::optional<double> total;
};

bool is_digit(char one) {
  return one >= '0' && one <= '9';
}

/// `12.30`, with this behind it.
std::optional<double> thousandths_of(std::string_view text, std::string_view behind) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::uint64_t units = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), units);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view rest = text.substr(static_cast<std::size_t>(stop - text.data()));
  const bool has_hundredths =
      rest.size() >= 3 && rest[0] == '.' && is_digit(rest[1]) && is_digit(rest[2]);
  if (!has_hundredths || rest.substr(3) != behind) return std::nullopt;
  const int hundredths = (rest[1] - '0') * 10 + (rest[2] - '0');
  return static_cast<double>(units) * money_unit + hundredths * (money_unit / 100);
}

/// `2026-11-21 18:02`
std::optional<std::int64_t> time_of(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minutes = 0;
  int end = 0;
  const int read = std::sscanf(text.c_str(), "%4d-%2u-%2u %2d:%2d%n", &year, &month, &day, &hour,
                               &minutes, &end);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (read != 5 || end != static_cast<int>(text.size()) || !date.ok()) return std::nullopt;
  const auto at =
      std::chrono::sys_days(date) + std::chrono::hours(hour) + std::chrono::minutes(minutes);
  return std::chrono::floor<std::chrono::seconds>(at).time_since_epoch().count();
}

/// What stands behind a word at the line's beginning.
std::optional<std::string> behind(const std::string& line, std::string_view word) {
  if (!line.starts_with(word)) return std::nullopt;
  return line.substr(word.size());
}

/// False: the line is none of a receipt.
bool take(Printed& receipt, const std::string& line) {
  const auto is_read = [](auto& place, const auto& value) {
    place = value;
    return place.has_value();
  };
  if (const auto text = behind(line, "From ")) return is_read(receipt.from, time_of(*text));
  if (const auto text = behind(line, "To   ")) return is_read(receipt.to, time_of(*text));
  if (const auto text = behind(line, "Distance ")) {
    return is_read(receipt.metres, thousandths_of(*text, " km"));
  }
  if (const auto text = behind(line, "Fare     ")) {
    return is_read(receipt.fare, thousandths_of(*text, ""));
  }
  if (const auto text = behind(line, "TOTAL    ")) {
    return is_read(receipt.total, thousandths_of(*text, ""));
  }
  if (const auto text = behind(line, "Extras   ")) {
    const auto extras = thousandths_of(*text, "");
    receipt.extras = extras.value_or(0);
    return extras.has_value();
  }
  return line == "EUR" || line.starts_with("TAXI ");
}

class Reader {
 public:
  Reader(std::span<const Trip> trips, std::int64_t local_begin)
      : trips_(trips),
        local_begin_(static_cast<double>(local_begin)),
        is_found_(trips.size()),
        may_have_pieces_(std::ranges::any_of(trips, &Trip::may_lack_receipt)) {}

  void read(std::span<const std::string> lines) {
    std::optional<Printed> receipt;
    for (const std::string& line : lines) {
      if (const auto number = behind(line, "Receipt ")) {
        if (receipt) judge(*receipt);
        receipt.emplace();
        std::from_chars(number->data(), number->data() + number->size(), receipt->number);
        continue;
      }
      if (!receipt && line.starts_with("TAXI ")) continue;
      const bool is_read = receipt && take(*receipt, line);
      expect(is_read || may_have_pieces_);
    }
    if (receipt) judge(*receipt);
    miss_others();
  }
  const ReceiptVerdict& verdict() const { return verdict_; }

 private:
  void expect(bool is_right) {
    ++verdict_.lines;
    if (!is_right) ++verdict_.wrong_lines;
  }

  void judge(const Printed& receipt) {
    if (!receipt.total) return expect(may_have_pieces_);
    ++verdict_.receipts;
    const bool is_of_trip = receipt.number >= 1 && receipt.number <= trips_.size();
    if (!is_of_trip) {
      verdict_.difference += *receipt.total;
      return;
    }
    is_found_[receipt.number - 1] = true;
    judge(receipt, trips_[receipt.number - 1]);
  }

  void judge(const Printed& receipt, const Trip& trip) {
    if (trip.is_read) verdict_.difference += std::abs(*receipt.total - trip.paid);
    expect(receipt.fare && is_same(*receipt.total, *receipt.fare + receipt.extras));
    expect(receipt.metres && is_distance(*receipt.metres, trip));
    if (trip.knows_extras) expect(is_same(receipt.extras, trip.pressed_extras));
    if (trip.is_read) expect(receipt.fare && is_same(*receipt.fare, trip.metered_fare));
    if (!trip.has_clock) return;
    expect(receipt.from && is_minute_of(*receipt.from, trip.begin));
    // When it was cut, the trip may have ended.
    expect(receipt.to && (trip.has_lost_power || is_minute_of(*receipt.to, trip.end)));
  }

  static bool is_same(double one, double other) { return std::abs(one - other) < same_amount; }
  static bool is_distance(double metres, const Trip& trip) {
    return metres <= trip.metres + trip.distance_limit() &&
           metres + printed_step >= trip.sure_metres - trip.distance_limit();
  }
  bool is_minute_of(std::int64_t printed, Time at) const {
    const double truth = local_begin_ + std::chrono::duration<double>(at - Time{}).count();
    const auto begin = static_cast<double>(printed);
    return truth >= begin - clock_seconds && truth < begin + minute + clock_seconds;
  }

  void miss_others() {
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      if (is_found_[i] || trips_[i].may_lack_receipt) continue;
      verdict_.difference += trips_[i].paid;
      ++verdict_.receipts;
    }
  }

  std::span<const Trip> trips_;
  double local_begin_;
  std::vector<bool> is_found_;
  bool may_have_pieces_;
  ReceiptVerdict verdict_;
};

}  // namespace

ReceiptVerdict judge_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              std::int64_t local_begin) {
  Reader reader(trips, local_begin);
  reader.read(lines);
  return reader.verdict();
}

bool says_amount(std::span<const std::string> lines, double amount) {
  std::array<char, 24> written{};
  std::snprintf(written.data(), written.size(), "%.2f", amount / money_unit);
  const std::string with_point = written.data();
  std::string with_comma = with_point;
  std::ranges::replace(with_comma, '.', ',');
  return std::ranges::any_of(lines, [&](const std::string& line) {
    return line.find(with_point) != std::string::npos || line.find(with_comma) != std::string::npos;
  });
}

}  // namespace canvoy::taxi
