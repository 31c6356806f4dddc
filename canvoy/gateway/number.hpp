// Numbers of a command line: decimal, or hexadecimal with 0x.
//
//     parse_unsigned("0x1018", 0xFFFF);  // 1018h
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace canvoy::gateway {

/// Number in a text. Nothing if the text is not a number, or is above `max`. A decimal number with
/// a leading zero is refused: other gateways read it as octal, and some people mean it as decimal.
inline std::optional<std::uint64_t> parse_unsigned(std::string_view text,
                                                   std::uint64_t max = UINT64_MAX) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) {
    text.remove_prefix(2);
  } else if (text.size() > 1 && text.front() == '0') {
    return std::nullopt;
  }
  std::uint64_t number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number, hexadecimal ? 16 : 10);
  const bool good = error == std::errc{} && end == text.data() + text.size() && number <= max;
  return good ? std::optional(number) : std::nullopt;
}

}  // namespace canvoy::gateway
