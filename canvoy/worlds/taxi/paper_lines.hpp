// Lines as people read them on the papers of a taxi: a name, followed by an amount, a length, a
// count or a time. And the facts that the readers compare them with.
//
//     const NamedLine line = named_line("Luggage            1.00");
//     line.name                       // "Luggage"
//     amount_of(line.rest, 2)         // 1000
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/currency.hpp"
#include "canvoy/devices/cia447/taximeter/tariff.hpp"
#include "canvoy/worlds/taxi/town_clock.hpp"

namespace canvoy::taxi {

/// Facts of town, taxi and driver with which a reader compares a paper. The objects that it refers
/// to must outlive it.
struct PaperTruth {
  TownClock clock;              ///< of the town
  cia447::Tariff tariff{};      ///< of the town
  cia447::Currency currency{};  ///< of the town
  std::string_view taxi{};      ///< 60DAh:04h
  std::string_view company{};   ///< empty: no line
  std::string_view driver{};    ///< empty: no line
  double vat_percent = 0;       ///< percentage included in TOTAL
};

/// The first 12 columns without the spaces at their end, and the rest of the line.
struct NamedLine {
  std::string_view name;  ///< without spaces at its end
  std::string_view rest;  ///< with spaces
};
/// Divides a line into both.
NamedLine named_line(std::string_view line);

/// Amount in thousandths of a text such as `12.30`, of a currency with so many decimals, followed
/// by this unit.
std::optional<double> amount_of(std::string_view text, unsigned decimals,
                                std::string_view behind = {});
/// Like amount_of(), but with the currency's symbol at its position.
std::optional<double> sum_of(std::string_view text, const cia447::Currency& currency);
/// Time of a text such as `2026-11-21 18:02`, in seconds since 1970-01-01.
std::optional<std::int64_t> minute_of(std::string_view text);
/// Duration of a text such as `0:03:20`, in seconds.
std::optional<double> span_of(std::string_view text);
/// Value of a whole number.
std::optional<double> count_of(std::string_view text);

/// True if both are the same amount.
bool is_same_amount(double one, double other);
/// True if a printed minute is that of a moment, of clocks that may be wrong by seconds.
bool is_minute_at(std::int64_t printed, const TownClock& clock, Time at);

}  // namespace canvoy::taxi
