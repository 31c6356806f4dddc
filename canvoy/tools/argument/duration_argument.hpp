// Durations on the command line: `30s`, `10min`, `8h`.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// Reads a duration above zero. Throws UsageError if it is none.
inline Duration parse_duration_argument(std::string_view text) {
  const auto duration = parse_duration(text);
  if (!duration || *duration <= Duration::zero()) {
    throw UsageError(
        fmt::format("'{}' is no time: write a number and {}, as 30s or 8h", text, duration_units));
  }
  return *duration;
}

/// Reads a time since a start: a duration, or zero.
inline Duration parse_moment_argument(std::string_view text) {
  const auto moment = parse_duration(text);
  return moment == Duration::zero() ? Duration::zero() : parse_duration_argument(text);
}

/// Reads a duration above zero, or returns `usual` for an empty text.
inline Duration parse_duration_argument(std::string_view text, Duration usual) {
  return text.empty() ? usual : parse_duration_argument(text);
}

}  // namespace canvoy::tools
