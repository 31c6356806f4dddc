#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"
#include "canvoy/profiles/cia447/printer.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint64_t cents = 100;
constexpr std::size_t amount_width = 8;

/// What there is of it beside whole units, in hundredths.
constexpr std::uint64_t cents_of(std::uint32_t amount) {
  return amount % thousandths * cents / thousandths;
}

}  // namespace

Receipt::Receipt(const TripData& trip, const ReceiptFacts& facts) {
  text_.add("TAXI ");
  text_.add(facts.taxi);
  text_.add("\nReceipt ");
  text_.add(facts.number);
  text_.add("\n");
  time("From ", trip.start, facts.utc_offset);
  time("To   ", trip.finish, facts.utc_offset);
  if (trip.distance != TripData::unknown) {
    text_.add("Distance ");
    text_.add(trip.distance / thousandths, amount_width);
    text_.add(".");
    text_.add(cents_of(trip.distance), 2, '0');
    text_.add(" ");
    text_.add(facts.distance_unit);
    text_.add("\n");
  }
  amount("Fare     ", trip.fare);
  if (trip.supplements != 0) amount("Extras   ", trip.supplements);
  amount("TOTAL    ", trip.total);
  text_.add(facts.currency);
  text_.add("\n\n\n");
  constexpr char cut = static_cast<char>(PrinterControl::cut_paper);
  text_.add({&cut, 1});
}

void Receipt::amount(std::string_view name, std::uint32_t amount) {
  text_.add(name);
  if (amount == TripData::unknown) {
    text_.add("       -\n");
    return;
  }
  text_.add(amount / thousandths, amount_width);
  text_.add(".");
  text_.add(cents_of(amount), 2, '0');
  text_.add("\n");
}

void Receipt::time(std::string_view name, std::uint32_t seconds, std::int32_t utc_offset) {
  if (seconds == TripData::unknown) return;
  text_.add(name).add_minute(std::int64_t{seconds} + utc_offset).add("\n");
}

}  // namespace canvoy::cia447
