// A span of time on the command line: `30s`, `10min`, `8h`.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

/// Above zero. Throws UsageError where it is none.
inline Duration parse_duration_argument(std::string_view text) {
  const auto duration = parse_duration(text);
  if (!duration || *duration <= Duration::zero()) {
    throw UsageError(
        fmt::format("'{}' is no time: write a number and {}, as 30s or 8h", text, duration_units));
  }
  return *duration;
}

/// When something happens, from a start on: the same, or zero.
inline Duration parse_moment_argument(std::string_view text) {
  const auto moment = parse_duration(text);
  return moment == Duration::zero() ? Duration::zero() : parse_duration_argument(text);
}

/// The same, or what is usual where nothing was said.
inline Duration parse_duration_argument(std::string_view text, Duration usual) {
  return text.empty() ? usual : parse_duration_argument(text);
}

}  // namespace canvoy::tools
