// Times in a filter.
//
//     parse_filter_time("1h30min");        // from the first frame on
//     parse_filter_time("1700000000.5");   // as lines have it
#pragma once

#include <optional>
#include <string_view>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

struct FilterTime {
  Duration time{};
  bool is_since_first = false;  ///< else since 1970, or since the start of a log without a date
};

/// Reads a duration (`10s`, `1h30min`), seconds without a unit, or `2026-11-21 12:00:00` (UTC).
/// Nothing if it is none of them.
std::optional<FilterTime> parse_filter_time(std::string_view text);

}  // namespace canvoy::tools
