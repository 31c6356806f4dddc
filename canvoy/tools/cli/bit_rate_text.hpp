// Bit rates on the command line, as the tools of this field write them: `125`, `125k`, `125000`,
// `125kbit/s`, `1M`.
//
//     parse_bit_rate("500k");  // 500'000
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/real_text.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

/// Reads a bit rate in bit/s; nothing if it is none, or above 1 Mbit/s. A number without a unit is
/// in kbit/s up to 1000, and in bit/s from 5000 on: no CAN bus is both.
inline std::optional<std::uint32_t> parse_bit_rate(std::string_view text) {
  struct Suffix {
    std::string_view name;
    double bits;
  };
  constexpr auto units = std::to_array<Suffix>({{"k", 1e3},
                                                {"kbit", 1e3},
                                                {"kbit/s", 1e3},
                                                {"kbps", 1e3},
                                                {"kbd", 1e3},
                                                {"kbaud", 1e3},
                                                {"m", 1e6},
                                                {"mbit", 1e6},
                                                {"mbit/s", 1e6},
                                                {"bit/s", 1},
                                                {"bps", 1},
                                                {"bd", 1},
                                                {"baud", 1}});
  constexpr double kilobits_max = 1e3;
  constexpr double bits_min = 5e3;
  constexpr double bits_max = 1e6;
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = real_from_chars(text.data(), end, number);
  if (error != std::errc{} || !(number > 0)) return std::nullopt;
  std::string unit;
  for (const char c : std::string_view(last, static_cast<std::size_t>(end - last))) {
    if (c != ' ') unit += in_lower_case(c);
  }
  double bits = 0;
  if (unit.empty() && number <= kilobits_max) bits = number * 1e3;
  if (unit.empty() && number >= bits_min) bits = number;
  for (const Suffix& each : units) {
    if (each.name == unit) bits = number * each.bits;
  }
  if (!(bits >= 1) || bits > bits_max || bits != std::floor(bits)) return std::nullopt;
  return static_cast<std::uint32_t>(bits);
}

}  // namespace canvoy::tools
