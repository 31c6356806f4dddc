// Texts that the taximeter prints: a receipt for a passenger, with the amounts paid; and a slip for
// the driver at the end of the shift, with the totals of 60D9h.
//
//     const Receipt receipt(trip, {.number = 7, .taxi = "M-TX 447"});
//     outputs.print(receipt.text());
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/currency.hpp"
#include "canvoy/devices/cia447/taximeter/fixed_text.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

namespace canvoy::cia447 {

/// Maximum size of a receipt and of a slip; the rest is left out.
inline constexpr std::size_t printed_text_max = 1024;

/// Taxi, company and driver, on each paper.
struct PaperHead {
  std::string_view taxi = "";           ///< 60DAh:04h
  std::string_view company = "";        ///< the operator; empty: no line
  std::string_view driver = "";         ///< empty: no line
  Currency currency = {};               ///< of all amounts
  std::string_view distance_unit = "";  ///< as printed: `km`
};

/// All that a receipt says.
struct ReceiptFacts {
  std::uint32_t number = 0;     ///< of the receipt
  PaperHead head = {};          ///< of the paper
  std::int32_t utc_offset = 0;  ///< s by which local clocks are ahead of UTC
  /// Offset at the start of the trip, if clocks were set in between.
  std::optional<std::int32_t> utc_offset_at_start = {};
  /// Kinds of the tariff, and the amount of each; the rest of all supplements is `Extras`.
  std::span<const SupplementKind> kinds = {};
  std::span<const std::uint32_t> of_kinds = {};  ///< in 0,001 of the currency unit
  /// Value-added tax included in TOTAL, in tenths of a percent; 0: no line.
  std::uint32_t vat_permille = 0;
  std::string_view payment = "";  ///< `cash`; empty: no line
};

/// Tax included in an amount, in whole coins, rounded half up.
constexpr std::uint32_t tax_in(std::uint32_t total, std::uint32_t permille, std::uint32_t coin) {
  constexpr std::uint64_t whole = 1000;
  const std::uint64_t coins = std::uint64_t{coin} * (whole + permille);
  return static_cast<std::uint32_t>((std::uint64_t{total} * permille + coins / 2) / coins * coin);
}

/// Lines of ASCII that end with 0Ah, and empty ones that feed the paper before it is cut.
class Receipt {
 public:
  /// Everything to which the facts refer is used only here.
  Receipt(const TripData& trip, const ReceiptFacts& facts);

  /// Valid as long as this.
  std::string_view text() const { return text_.view(); }

 private:
  void supplements(const TripData& trip, const ReceiptFacts& facts);

  FixedText<printed_text_max> text_;
};

/// All that a slip says.
struct SlipFacts {
  PaperHead head = {};           ///< of the paper
  std::int64_t begin = no_time;  ///< of the shift, in local seconds since 1970-01-01
  std::int64_t end = no_time;    ///< of the shift, in local seconds since 1970-01-01
};

/// The totals of a shift, and the overall totals (MI-007, 15).
class ShiftSlip {
 public:
  /// Each as in 60D9h.
  ShiftSlip(const TaxiTotals& shift, const TaxiTotals& total, const SlipFacts& facts);

  /// Valid as long as this.
  std::string_view text() const { return text_.view(); }

 private:
  FixedText<printed_text_max> text_;
};

}  // namespace canvoy::cia447
