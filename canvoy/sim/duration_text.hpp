// Durations as text, `250us`, `100ms`, `30s`, `1.5min`, `1h30min`, and as numbers for formulas.
//
//     std::optional<Duration> length = parse_duration("8h");
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// Names of the units on a command line.
inline constexpr std::string_view duration_units = "us, ms, s, min or h";

/// Parses a decimal number, with a decimal point where needed, and one of the units; or several of
/// them, each in a smaller unit than the one before, with or without a blank between them or before
/// a unit: `1h30min`, `1min 30s`, `500 ms`. Each is rounded down to a microsecond. Empty for any
/// other text, and for more than a hundred years.
std::optional<Duration> parse_duration(std::string_view text);

/// Text that parse_duration() reads as this duration, in the largest unit that expresses it
/// exactly: `90s`, `8h`; none is `0s`.
std::string written(Duration duration);

/// The duration in seconds, for formulas.
inline double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace canvoy
