// The fields of an NMEA 0183 sentence, and the numbers in them. For nmea.hpp.
//
//     NmeaFields fields("GPVTG,054.7,T,034.4,M,005.5,N,010.2,K");
//     fields.next();            // "GPVTG"
//     decimal(fields.next());   // 54.7
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace canvoy::cia447 {

/// Fields beyond the last one are empty.
class NmeaFields {
 public:
  /// Begins at the first field.
  constexpr explicit NmeaFields(std::string_view sentence) : rest_(sentence) {}

  /// Next field; empty behind the last one.
  constexpr std::string_view next() {
    const std::size_t comma = rest_.find(',');
    const std::string_view field = rest_.substr(0, comma);
    rest_.remove_prefix(comma == std::string_view::npos ? rest_.size() : comma + 1);
    return field;
  }
  /// Leaves fields out.
  constexpr void skip(unsigned count) {
    for (unsigned i = 0; i < count; ++i) next();
  }

 private:
  std::string_view rest_;
};

/// At most nine digits and nothing else; otherwise nothing.
constexpr std::optional<unsigned> digits(std::string_view text) {
  if (text.empty() || text.size() > 9) return std::nullopt;
  unsigned number = 0;
  for (const char one : text) {
    if (one < '0' || one > '9') return std::nullopt;
    number = number * 10 + static_cast<unsigned>(one - '0');
  }
  return number;
}

/// "-12.5": an optional sign, digits, an optional point, at most 15 digits in all. Otherwise
/// nothing.
constexpr std::optional<double> decimal(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  std::int64_t number = 0;
  std::int64_t scale = 0;
  unsigned count = 0;
  for (const char one : text) {
    if (one == '.' && scale == 0) {
      scale = 1;
      continue;
    }
    if (one < '0' || one > '9' || ++count > 15) return std::nullopt;
    number = number * 10 + (one - '0');
    scale *= 10;
  }
  if (count == 0) return std::nullopt;
  const double value = static_cast<double>(number) / static_cast<double>(scale > 0 ? scale : 1);
  return is_negative ? -value : value;
}

}  // namespace canvoy::cia447
