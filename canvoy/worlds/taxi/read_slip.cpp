#include "canvoy/worlds/taxi/read_slip.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace canvoy::taxi {

namespace {

/// MI-007, 7: 0.2 % of the distance, at least 4 m; and hundredths of a kilometre are printed.
constexpr double slip_distance_share = 0.002;
constexpr double slip_distance_least = 4;
constexpr double slip_printed_step = 10;
constexpr unsigned slip_distance_decimals = 2;

constexpr std::string_view totals[] = {"Driven", "Hired",       "Hirings",
                                       "Fares",  "Supplements", "INCOME"};

using Totals = std::map<std::string_view, double>;

struct Slip {
  bool has_taxi = false;
  bool has_company = false;
  bool has_driver = false;
  std::optional<std::int64_t> from;
  std::optional<std::int64_t> to;
  Totals parts[2];  ///< of the shift, and of the total time
};

class SlipReader {
 public:
  explicit SlipReader(const PaperTruth& truth) : truth_(truth) {}

  void read(std::span<const std::string> lines) {
    const auto first = std::ranges::find_if(
        lines, [](const std::string& line) { return line.starts_with("SHIFT OF "); });
    for (auto line = first; line != lines.end(); ++line) expect(take(*line));
  }

  void judge(std::span<const Trip> trips, const DrivenShift& shift) {
    double hired = 0;
    double hired_limit = slip_distance_least;
    double fares = 0;
    double supplements = 0;
    for (const Trip& trip : trips) {
      hired += trip.metres;
      hired_limit += trip.distance_limit();
      fares += trip.metered_fare;
      supplements += trip.extras;
    }
    expect(slip_.has_taxi && (slip_.has_company || truth_.company.empty()) &&
           (slip_.has_driver || truth_.driver.empty()));
    expect(slip_.from && is_minute_at(*slip_.from, truth_.clock, shift.begin));
    expect(slip_.to && is_minute_at(*slip_.to, truth_.clock, shift.end));
    expect_near("Driven", shift.metres, slip_distance_least + slip_distance_share * shift.metres);
    expect_near("Hired", hired, hired_limit);
    expect_amount("Hirings", static_cast<double>(trips.size()));
    expect_amount("Fares", fares);
    expect_amount("Supplements", supplements);
    expect_amount("INCOME", fares + supplements);
    for (const std::string_view name : totals) {
      const auto all = of(name, 1);
      expect(all && *all >= of(name, 0).value_or(0));
    }
  }
  const SlipVerdict& verdict() const { return verdict_; }

 private:
  void expect(bool is_right) {
    ++verdict_.lines;
    if (!is_right) ++verdict_.wrong_lines;
  }
  std::optional<double> of(std::string_view name, std::size_t part) const {
    const auto found = slip_.parts[part].find(name);
    return found == slip_.parts[part].end() ? std::nullopt : std::optional(found->second);
  }
  void expect_amount(std::string_view name, double amount) {
    const auto printed = of(name, 0);
    expect(printed && is_same_amount(*printed, amount));
  }
  void expect_near(std::string_view name, double metres, double limit) {
    const auto printed = of(name, 0);
    expect(printed && *printed <= metres + limit && *printed + slip_printed_step >= metres - limit);
  }

  /// False: the line is not part of a slip.
  bool take(std::string_view line) {
    constexpr std::string_view head = "SHIFT OF ";
    constexpr std::string_view driver = "Driver ";
    constexpr std::size_t times = 5;
    if (line.starts_with(head)) return slip_.has_taxi = line.substr(head.size()) == truth_.taxi;
    if (!truth_.company.empty() && line == truth_.company) return slip_.has_company = true;
    if (line.starts_with(driver)) {
      return slip_.has_driver = line.substr(driver.size()) == truth_.driver;
    }
    if (line.starts_with("From ")) return bool(slip_.from = minute_of(line.substr(times)));
    if (line.starts_with("To   ")) return bool(slip_.to = minute_of(line.substr(times)));
    if (line == "Shift") return part_ = 0, true;
    if (line == "All time") return part_ = 1, true;
    return take_total(named_line(line));
  }

  bool take_total(const NamedLine& line) {
    const auto* const name = std::ranges::find(totals, line.name);
    if (name == std::end(totals)) return false;
    std::optional<double> number = amount_of(line.rest, truth_.currency.decimals());
    if (*name == "Driven" || *name == "Hired") {
      number = amount_of(line.rest, slip_distance_decimals, " km");
    } else if (*name == "Hirings") {
      number = count_of(line.rest);
    } else if (*name == "INCOME") {
      number = sum_of(line.rest, truth_.currency);
    }
    return number && part_ && slip_.parts[*part_].emplace(*name, *number).second;
  }

  const PaperTruth& truth_;
  Slip slip_;
  std::optional<std::size_t> part_;  ///< empty: above both
  SlipVerdict verdict_;
};

}  // namespace

SlipVerdict judge_slip(std::span<const std::string> lines, std::span<const Trip> trips,
                       const PaperTruth& truth, const DrivenShift& shift) {
  SlipReader reader(truth);
  reader.read(lines);
  reader.judge(trips, shift);
  return reader.verdict();
}

}  // namespace canvoy::taxi
