// The currency of a tariff: its name and its smallest coin. All amounts that are shown, printed and
// paid are whole coins; a meter counts in 0,001 of the currency unit, as in 60D0h (CiA 447-3,
// 4.2.12.1; MI-007, 7).
//
//     constexpr Currency francs = {.code = "CHF", .symbol = "Fr.", .leads = true, .coin = 50};
//     add_amount(text, 12'350, francs, 8);    // "   12.35"
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/fixed_text.hpp"

namespace canvoy::cia447 {

/// Local units, as in 60DAh:08h.
struct Currency {
  std::string_view code = "EUR";    ///< of 60DAh:08h
  std::string_view symbol = "EUR";  ///< in ASCII, beside TOTAL on receipts
  bool leads = false;               ///< the symbol is before the amount
  std::uint32_t coin = 10;          ///< the smallest coin, in 0,001 of the unit; at least 1

  /// Number of digits behind the decimal point: none, two or three.
  constexpr unsigned decimals() const {
    if (coin % thousandths == 0) return 0;
    return coin % 10 == 0 ? 2 : 3;
  }
  static constexpr std::uint32_t thousandths = 1000;  ///< of a unit
};

/// ` 12.30`: right-aligned in `width`. A rest below its last decimal is cut off.
template <std::size_t capacity>
void add_amount(FixedText<capacity>& text, std::uint32_t amount, const Currency& currency,
                std::size_t width) {
  constexpr std::uint32_t of_last[] = {Currency::thousandths, 100, 10, 1};
  const unsigned decimals = currency.decimals();
  const std::size_t behind = decimals == 0 ? 0 : decimals + std::size_t{1};
  text.add(amount / Currency::thousandths, width > behind ? width - behind : 1);
  if (decimals == 0) return;
  text.add(".").add(amount % Currency::thousandths / of_last[decimals], decimals, '0');
}

}  // namespace canvoy::cia447
