#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"
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
  add("TAXI ");
  add(facts.taxi);
  add("\nReceipt ");
  add(facts.number);
  add("\n");
  time("From ", trip.start, facts.utc_offset);
  time("To   ", trip.finish, facts.utc_offset);
  if (trip.distance != TripData::unknown) {
    add("Distance ");
    add(trip.distance / thousandths, amount_width);
    add(".");
    add(cents_of(trip.distance), 2, '0');
    add(" ");
    add(facts.distance_unit);
    add("\n");
  }
  amount("Fare     ", trip.fare);
  if (trip.supplements != 0) amount("Extras   ", trip.supplements);
  amount("TOTAL    ", trip.total);
  add(facts.currency);
  add("\n\n\n");
  constexpr char cut = static_cast<char>(PrinterControl::cut_paper);
  add({&cut, 1});
}

/// What there is no room for is left out.
void Receipt::add(std::string_view text) {
  const std::size_t count = std::min(text.size(), text_.size() - length_);
  std::copy_n(text.begin(), count, text_.begin() + static_cast<std::ptrdiff_t>(length_));
  length_ += count;
}

void Receipt::add(std::uint64_t number, std::size_t width, char filler) {
  constexpr std::size_t digits_max = 20;
  std::array<char, digits_max> digits;
  digits.fill(filler);
  std::size_t first = digits_max;
  do {
    digits[--first] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  first = std::min(first, digits_max - width);
  add(std::string_view(digits.data() + first, digits_max - first));
}

void Receipt::amount(std::string_view name, std::uint32_t amount) {
  add(name);
  if (amount == TripData::unknown) return add("       -\n");
  add(amount / thousandths, amount_width);
  add(".");
  add(cents_of(amount), 2, '0');
  add("\n");
}

void Receipt::time(std::string_view name, std::uint32_t seconds, std::int32_t utc_offset) {
  if (seconds == TripData::unknown) return;
  const CivilTime at = civil_time(std::int64_t{seconds} + utc_offset);
  add(name);
  add(static_cast<std::uint64_t>(at.year), 4, '0');
  add("-");
  add(at.month, 2, '0');
  add("-");
  add(at.day, 2, '0');
  add(" ");
  add(at.hour, 2, '0');
  add(":");
  add(at.minute, 2, '0');
  add("\n");
}

}  // namespace canvoy::cia447
