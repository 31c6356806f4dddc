#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"
#include "canvoy/profiles/cia447/printer.hpp"

namespace canvoy::cia447 {

namespace {

using ReceiptText = FixedText<printed_text_max>;

constexpr std::size_t receipt_name_width = 12;
constexpr std::size_t receipt_amount_width = 11;

ReceiptText& begin_named(ReceiptText& text, std::string_view name) {
  name = name.substr(0, receipt_name_width - 1);
  text.add(name);
  for (std::size_t i = name.size(); i < receipt_name_width; ++i) text.add(" ");
  return text;
}

/// A separate line; nothing for an empty text.
void text_line(ReceiptText& text, std::string_view name, std::string_view what) {
  if (!what.empty()) text.add(name).add(what).add("\n");
}

void amount_line(ReceiptText& text, std::string_view name, std::uint32_t amount,
                 const Currency& currency) {
  begin_named(text, name);
  if (amount == TripData::unknown) {
    text.add("          -\n");
    return;
  }
  add_amount(text, amount, currency, receipt_amount_width);
  text.add("\n");
}

/// With the symbol behind or before the amount.
void sum_line(ReceiptText& text, std::string_view name, std::uint32_t sum,
              const Currency& currency) {
  if (sum == TripData::unknown) return amount_line(text, name, sum, currency);
  begin_named(text, name);
  const std::size_t symbol = currency.leads ? currency.symbol.size() + 1 : 0;
  if (currency.leads) text.add(currency.symbol).add(" ");
  add_amount(text, sum, currency,
             receipt_amount_width > symbol ? receipt_amount_width - symbol : 1);
  if (!currency.leads) text.add(" ").add(currency.symbol);
  text.add("\n");
}

void distance_line(ReceiptText& text, std::string_view name, std::uint32_t distance,
                   std::string_view unit) {
  if (distance == TripData::unknown) return;
  begin_named(text, name);
  add_amount(text, distance, {}, receipt_amount_width);
  text.add(" ").add(unit).add("\n");
}

void count_line(ReceiptText& text, std::string_view name, std::uint32_t count) {
  begin_named(text, name).add(count, receipt_amount_width).add("\n");
}

/// `0:03:20`
void span_line(ReceiptText& text, std::string_view name, std::uint32_t seconds) {
  if (seconds == TripData::unknown) return;
  constexpr std::uint32_t an_hour = 3600;
  constexpr std::uint32_t a_minute = 60;
  constexpr std::size_t hours_width = 5;
  begin_named(text, name)
      .add(seconds / an_hour, hours_width)
      .add(":")
      .add(seconds % an_hour / a_minute, 2, '0')
      .add(":")
      .add(seconds % a_minute, 2, '0')
      .add("\n");
}

void moment_line(ReceiptText& text, std::string_view name, std::int64_t local_seconds) {
  text.add(name).add_minute(local_seconds).add("\n");
}
void moment_line(ReceiptText& text, std::string_view name, std::uint32_t seconds,
                 std::int32_t utc_offset) {
  if (seconds != TripData::unknown) moment_line(text, name, std::int64_t{seconds} + utc_offset);
}

void cut_off(ReceiptText& text) {
  constexpr char cut = static_cast<char>(PrinterControl::cut_paper);
  text.add("\n\n").add({&cut, 1});
}

void level_line(ReceiptText& text, const std::array<std::uint8_t, 2>& level) {
  std::array<char, 2> name{};
  std::size_t length = 0;
  for (const std::uint8_t character : level) {
    if (character > ' ' && character < 0x7F) name[length++] = static_cast<char>(character);
  }
  text_line(text, "Tariff ", {name.data(), length});
}

/// `VAT 7.0 %         0.86`
void tax_line(ReceiptText& text, std::uint32_t total, const ReceiptFacts& facts) {
  if (facts.vat_permille == 0 || total == TripData::unknown) return;
  FixedText<receipt_name_width> name;
  name.add("VAT ").add(facts.vat_permille / 10).add(".").add(facts.vat_permille % 10).add(" %");
  const Currency& currency = facts.head.currency;
  amount_line(text, name.view(), tax_in(total, facts.vat_permille, currency.coin), currency);
}

}  // namespace

Receipt::Receipt(const TripData& trip, const ReceiptFacts& facts) {
  const PaperHead& head = facts.head;
  text_.add("TAXI ").add(head.taxi).add("\n");
  text_line(text_, "", head.company);
  text_.add("Receipt ").add(facts.number).add("\n");
  text_line(text_, "Driver ", head.driver);
  moment_line(text_, "From ", trip.start, facts.utc_offset_at_start.value_or(facts.utc_offset));
  moment_line(text_, "To   ", trip.finish, facts.utc_offset);
  level_line(text_, trip.level);
  distance_line(text_, "Distance", trip.distance, head.distance_unit);
  span_line(text_, "Waiting", trip.waiting);
  const bool is_agreed = trip.mode == FareMode::fixed_price;
  amount_line(text_, is_agreed ? "Agreed" : "Fare", trip.fare, head.currency);
  supplements(trip, facts);
  sum_line(text_, "TOTAL", trip.total, head.currency);
  tax_line(text_, trip.total, facts);
  text_line(text_, "Paid: ", facts.payment);
  cut_off(text_);
}

/// Supplements without an amount have no line.
void Receipt::supplements(const TripData& trip, const ReceiptFacts& facts) {
  if (trip.supplements == TripData::unknown) {
    return amount_line(text_, "Extras", trip.supplements, facts.head.currency);
  }
  std::uint64_t of_kinds = 0;
  const std::size_t kinds = std::min(facts.kinds.size(), facts.of_kinds.size());
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    if (facts.of_kinds[kind] == 0) continue;
    of_kinds += facts.of_kinds[kind];
    amount_line(text_, facts.kinds[kind].name, facts.of_kinds[kind], facts.head.currency);
  }
  if (trip.supplements > of_kinds) {
    const auto others = static_cast<std::uint32_t>(trip.supplements - of_kinds);
    amount_line(text_, "Extras", others, facts.head.currency);
  }
}

ShiftSlip::ShiftSlip(const TaxiTotals& shift, const TaxiTotals& total, const SlipFacts& facts) {
  const PaperHead& head = facts.head;
  text_.add("SHIFT OF ").add(head.taxi).add("\n");
  text_line(text_, "", head.company);
  text_line(text_, "Driver ", head.driver);
  if (facts.begin != no_time) moment_line(text_, "From ", facts.begin);
  if (facts.end != no_time) moment_line(text_, "To   ", facts.end);
  for (const bool is_of_all_time : {false, true}) {
    const TaxiTotals& of = is_of_all_time ? total : shift;
    text_.add(is_of_all_time ? "All time\n" : "Shift\n");
    distance_line(text_, "Driven", of.distance, head.distance_unit);
    distance_line(text_, "Hired", of.distance_hired, head.distance_unit);
    count_line(text_, "Hirings", of.hirings);
    amount_line(text_, "Fares", of.fare, head.currency);
    amount_line(text_, "Supplements", of.supplements, head.currency);
    sum_line(text_, "INCOME", of.income, head.currency);
  }
  cut_off(text_);
}

}  // namespace canvoy::cia447
