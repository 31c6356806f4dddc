#include "canvoy/sim/taxi/read_receipts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>

namespace canvoy::taxi {

double difference_of_receipts(std::span<const std::string> lines, std::span<const Trip> trips,
                              bool some_may_lack) {
  constexpr std::string_view number_word = "Receipt ";
  constexpr std::string_view total_word = "TOTAL";
  std::map<std::size_t, double> totals;  // by the number of the trip
  std::size_t number = 0;
  for (const std::string& line : lines) {
    if (line.starts_with(number_word)) number = std::stoul(line.substr(number_word.size()));
    if (!line.starts_with(total_word)) continue;
    totals[number] = std::round(std::stod(line.substr(total_word.size())) * money_unit);
  }
  double error = 0;
  for (std::size_t trip = 1; trip <= trips.size(); ++trip) {
    const auto printed = totals.extract(trip);
    if (printed.empty() && some_may_lack) continue;
    error += std::abs((printed.empty() ? 0 : printed.mapped()) - trips[trip - 1].paid);
  }
  for (const auto& [no_trip, total] : totals) error += total;
  return error;
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
