// Spans of time as people write them, `250us`, `100ms`, `30s`, `1.5min`, `1h30min`, and as
// formulas take them.
//
//     std::optional<Duration> length = parse_duration("8h");
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// What a command line calls the units.
inline constexpr std::string_view duration_units = "us, ms, s, min or h";

/// A decimal number, a dot and further digits where wanted, and one of the units; several of them
/// where each unit is smaller than the one before, with a blank between them, or in front of a
/// unit, or none: `1h30min`, `1min 30s`, `500 ms`. Each is rounded down to a microsecond. Empty for
/// anything else, and for more than a hundred years.
std::optional<Duration> parse_duration(std::string_view text);

/// What parse_duration() reads as the same, in the largest unit that says it exactly: `90s`, `8h`.
std::string written(Duration duration);

inline double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace canvoy
