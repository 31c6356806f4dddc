// A receipt, as the taximeter has its printer print it: what a passenger has paid, for what.
//
//     const Receipt receipt(trip, {.number = 7, .currency = "EUR", .taxi = "M-TX 447"});
//     outputs.print(receipt.text());
#pragma once

#include <cstdint>
#include <string_view>

#include "canvoy/devices/cia447/taximeter/fixed_text.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

namespace canvoy::cia447 {

struct ReceiptFacts {
  std::uint32_t number = 0;
  std::string_view taxi = "";
  std::string_view currency = "";
  std::string_view distance_unit = "";
  std::int32_t utc_offset = 0;  ///< s that clocks here are ahead of UTC
};

/// Lines of ASCII that end with 0Ah, and empty ones, by which the paper comes out; then it is cut.
class Receipt {
 public:
  Receipt(const TripData& trip, const ReceiptFacts& facts);

  std::string_view text() const { return text_.view(); }

 private:
  void amount(std::string_view name, std::uint32_t amount);
  void time(std::string_view name, std::uint32_t seconds, std::int32_t utc_offset);

  FixedText<512> text_;
};

}  // namespace canvoy::cia447
