#include "canvoy/worlds/taxi/read_receipts.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

namespace canvoy::taxi {

namespace {

/// A receipt shows hundredths of a kilometre.
constexpr double printed_step = 10;
constexpr unsigned distance_decimals = 2;
constexpr std::size_t name_length_max = 11;

/// Values of a receipt: amounts in thousandths, times in seconds since 1970-01-01.
struct Printed {
  std::size_t number = 0;
  bool has_taxi = false;
  bool has_company = false;
  bool has_driver = false;
  std::optional<std::int64_t> from;
  std::optional<std::int64_t> to;
  std::string_view level;
  std::optional<double> metres;
  std::optional<double> waiting;
  std::optional<double> fare;
  std::optional<double> agreed;
  std::array<double, cia447::supplement_kinds_max> of_kinds{};
  double extras = 0;  ///< beside those of the tariff
  std::optional<double> total;
  std::optional<double> tax;
  std::string_view tax_name;
  std::string_view payment;
};

/// Text after a word at the beginning of the line.
std::optional<std::string_view> behind(std::string_view line, std::string_view word) {
  if (!line.starts_with(word)) return std::nullopt;
  return line.substr(word.size());
}

template <class Place, class Value>
bool is_read(Place& place, const Value& value) {
  if (value) place = *value;
  return value.has_value();
}

std::string text_of(std::array<char, 2> name) {
  return {name.data(), name[1] == 0 ? 1U : 2U};
}

class Reader {
 public:
  Reader(std::span<const Trip> trips, const PaperTruth& truth)
      : trips_(trips),
        truth_(truth),
        is_found_(trips.size()),
        may_have_pieces_(std::ranges::any_of(trips, &Trip::may_lack_receipt)) {}

  void read(std::span<const std::string> lines) {
    for (const std::string& line : lines) {
      const bool begins = line.starts_with("TAXI ");
      const auto number = behind(line, "Receipt ");
      if (begins || (number && (!receipt_ || receipt_->number != 0))) {
        end();
        receipt_.emplace();
      }
      if (number) {
        std::from_chars(number->data(), number->data() + number->size(), receipt_->number);
      } else {
        expect((receipt_ && take(*receipt_, line)) || may_have_pieces_);
      }
    }
    end();
    miss_others();
  }
  const ReceiptVerdict& verdict() const { return verdict_; }

 private:
  void expect(bool is_right) {
    ++verdict_.lines;
    if (!is_right) ++verdict_.wrong_lines;
  }

  /// False: the line is not part of a receipt.
  bool take(Printed& receipt, std::string_view line) const {
    if (const auto text = behind(line, "TAXI ")) return receipt.has_taxi = *text == truth_.taxi;
    if (!truth_.company.empty() && line == truth_.company) return receipt.has_company = true;
    if (const auto text = behind(line, "Driver ")) {
      return receipt.has_driver = *text == truth_.driver;
    }
    if (const auto text = behind(line, "From ")) return is_read(receipt.from, minute_of(*text));
    if (const auto text = behind(line, "To   ")) return is_read(receipt.to, minute_of(*text));
    if (const auto text = behind(line, "Tariff ")) return is_read(receipt.level, text);
    if (const auto text = behind(line, "Paid: ")) return is_read(receipt.payment, text);
    return take_amount(receipt, named_line(line));
  }

  bool take_amount(Printed& receipt, const NamedLine& line) const {
    const unsigned decimals = truth_.currency.decimals();
    const auto amount = amount_of(line.rest, decimals);
    if (line.name == "Distance") {
      return is_read(receipt.metres, amount_of(line.rest, distance_decimals, " km"));
    }
    if (line.name == "Waiting") return is_read(receipt.waiting, span_of(line.rest));
    if (line.name == "Fare") return is_read(receipt.fare, amount);
    if (line.name == "Agreed") return is_read(receipt.agreed, amount);
    if (line.name == "Extras") return is_read(receipt.extras, amount);
    if (line.name == "TOTAL") return is_read(receipt.total, sum_of(line.rest, truth_.currency));
    if (line.name.starts_with("VAT ")) {
      receipt.tax_name = line.name;
      return is_read(receipt.tax, amount);
    }
    const auto& kinds = truth_.tariff.supplements;
    const auto kind = std::ranges::find_if(kinds, [&line](const cia447::SupplementKind& each) {
      return each.name.substr(0, name_length_max) == line.name;
    });
    const auto place = static_cast<std::size_t>(kind - kinds.begin());
    return kind != kinds.end() && is_read(receipt.of_kinds.at(place), amount);
  }

  /// A receipt without TOTAL is incomplete.
  void end() {
    const std::optional<Printed> receipt = std::exchange(receipt_, std::nullopt);
    if (!receipt) return;
    if (!receipt->total) return expect(may_have_pieces_);
    ++verdict_.receipts;
    const bool is_of_trip = receipt->number >= 1 && receipt->number <= trips_.size();
    if (!is_of_trip) {
      verdict_.difference += *receipt->total;
      return;
    }
    expect(!is_found_[receipt->number - 1] || trips_[receipt->number - 1].may_lack_receipt);
    is_found_[receipt->number - 1] = true;
    judge(*receipt, trips_[receipt->number - 1]);
  }

  void judge(const Printed& receipt, const Trip& trip) {
    if (trip.is_read) verdict_.difference += std::abs(*receipt.total - trip.paid);
    expect(receipt.has_taxi && (receipt.has_company || truth_.company.empty()) &&
           (receipt.has_driver || truth_.driver.empty()));
    expect(receipt.metres && is_distance(*receipt.metres, trip));
    judge_amounts(receipt, trip);
    expect(receipt.payment == (trip.is_by_card ? "card" : "cash"));
    if (trip.has_clock) judge_times(receipt, trip);
  }

  void judge_amounts(const Printed& receipt, const Trip& trip) {
    const std::optional<double> fare = trip.agreed ? receipt.agreed : receipt.fare;
    double extras = receipt.extras;
    for (const double amount : receipt.of_kinds) extras += amount;
    expect(fare && is_same_amount(*receipt.total, *fare + extras));
    if (trip.is_read) expect(fare && is_same_amount(*fare, trip.metered_fare));
    if (trip.knows_extras) expect(are_extras(receipt, trip));
    expect(is_tax(receipt));
  }

  /// True if each service is there at the town's price, as often as it was used.
  bool are_extras(const Printed& receipt, const Trip& trip) const {
    double others = trip.pressed_extras;
    const std::size_t kinds = std::min(truth_.tariff.supplements.size(), trip.pressed.size());
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const double asked = 1.0 * truth_.tariff.supplements[kind].price * trip.pressed.at(kind);
      if (!is_same_amount(receipt.of_kinds.at(kind), asked)) return false;
      others -= asked;
    }
    return is_same_amount(receipt.extras, others);
  }

  /// `VAT 7.0 %`
  std::string tax_name() const {
    std::array<char, 24> name{};
    std::snprintf(name.data(), name.size(), "VAT %.1f %%", truth_.vat_percent);
    return name.data();
  }

  bool is_tax(const Printed& receipt) const {
    if (truth_.vat_percent == 0) return !receipt.tax;
    const double coin = truth_.currency.coin;
    const double share = truth_.vat_percent / (100 + truth_.vat_percent);
    return receipt.tax && receipt.tax_name == tax_name() &&
           std::abs(*receipt.tax - *receipt.total * share) <= coin / 2 + 1e-6;
  }

  void judge_times(const Printed& receipt, const Trip& trip) {
    expect(receipt.from && is_minute_at(*receipt.from, truth_.clock, trip.begin));
    // When power was lost, the trip may have ended.
    if (trip.has_lost_power) return expect(receipt.to.has_value());
    expect(receipt.to && is_minute_at(*receipt.to, truth_.clock, trip.end));
    expect(receipt.level == text_of(trip.levels[0]) || receipt.level == text_of(trip.levels[1]));
    const bool is_waiting = receipt.waiting && *receipt.waiting >= trip.waiting_low - 1 &&
                            *receipt.waiting <= trip.waiting_high;
    if (trip.is_read) expect(is_waiting);
  }

  static bool is_distance(double metres, const Trip& trip) {
    return metres <= trip.metres + trip.distance_limit() &&
           metres + printed_step >= trip.sure_metres - trip.distance_limit();
  }

  void miss_others() {
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      if (is_found_[i] || trips_[i].may_lack_receipt) continue;
      verdict_.difference += trips_[i].paid;
      ++verdict_.receipts;
    }
  }

  std::span<const Trip> trips_;
  const PaperTruth& truth_;
  std::vector<bool> is_found_;
  bool may_have_pieces_;
  std::optional<Printed> receipt_;
  ReceiptVerdict verdict_;
};

}  // namespace

ReceiptVerdict judge_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              const PaperTruth& truth) {
  Reader reader(trips, truth);
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
