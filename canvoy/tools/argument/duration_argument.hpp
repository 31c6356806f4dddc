// Durations on the command line: `30s`, `10min`, `8h`.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// What is wrong with a text as a duration above zero; empty: nothing.
inline std::string wrong_duration(const std::string& text) {
  const auto duration = parse_duration(text);
  if (duration && *duration > Duration::zero()) return "";
  const std::size_t number = std::min(text.find_first_not_of("0123456789."), text.size());
  if (!duration && number != 0 && number == text.size()) {
    return fmt::format("'{0}' has no unit: {0}ms, {0}s or {0}min", text);
  }
  if (!duration && number != 0 && parse_duration("1" + text.substr(number))) {
    return fmt::format("'{}' is more than a hundred years", text);
  }
  return fmt::format("'{}' is no time: write a number and {}, as 30s or 8h", text, duration_units);
}

/// Reads a duration above zero. Throws UsageError if it is none.
inline Duration parse_duration_argument(std::string_view text) {
  const std::string wrong = wrong_duration(std::string(text));
  if (!wrong.empty()) throw UsageError(wrong);
  return *parse_duration(text);
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
