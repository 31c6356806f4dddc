#include "canvoy/devices/cia447/taximeter/receipt.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"
#include "canvoy/devices/cia447/taximeter/fare_calculation.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint32_t cents = 100;

int length_of(std::string_view text) {
  return static_cast<int>(text.size());
}

}  // namespace

Receipt::Receipt(const TripData& trip, const ReceiptFacts& facts) {
  line("TAXI %.*s", length_of(facts.taxi), facts.taxi.data());
  line("Receipt %u", static_cast<unsigned>(facts.number));
  time("From", trip.start, facts.utc_offset);
  time("To", trip.finish, facts.utc_offset);
  if (trip.distance != TripData::unknown) {
    line("Distance %8u.%02u %.*s", static_cast<unsigned>(trip.distance / thousandths),
         static_cast<unsigned>(trip.distance % thousandths * cents / thousandths),
         length_of(facts.distance_unit), facts.distance_unit.data());
  }
  amount("Fare", trip.fare);
  if (trip.supplements != 0) amount("Extras", trip.supplements);
  amount("TOTAL", trip.total);
  line("%.*s", length_of(facts.currency), facts.currency.data());
  line("\n");
}

/// What there is no room for is left out.
void Receipt::line(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  const std::size_t room = text_.size() - length_ - 1;
  const int wanted = std::vsnprintf(text_.data() + length_, room, format, arguments);
  va_end(arguments);
  length_ += std::min<std::size_t>(static_cast<std::size_t>(std::max(wanted, 0)), room - 1);
  text_[length_++] = '\n';
}

void Receipt::amount(const char* name, std::uint32_t amount) {
  if (amount == TripData::unknown) return line("%-8s        -", name);
  line("%-8s %8u.%02u", name, static_cast<unsigned>(amount / thousandths),
       static_cast<unsigned>(amount % thousandths * cents / thousandths));
}

void Receipt::time(const char* name, std::uint32_t seconds, std::int32_t utc_offset) {
  if (seconds == TripData::unknown) return;
  const CivilTime at = civil_time(std::int64_t{seconds} + utc_offset);
  line("%-5s %04lld-%02u-%02u %02u:%02u", name, static_cast<long long>(at.year), at.month, at.day,
       at.hour, at.minute);
}

}  // namespace canvoy::cia447
