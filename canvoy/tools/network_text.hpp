// Values as a network file has them.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/time_of_day.hpp"

namespace canvoy::tools {

/// As parse_duration() reads it, in the largest unit that says it exactly: `90s`, `8h`.
std::string duration_value(Duration duration);
/// A text in quotes.
std::string text_value(std::string_view text);
/// A local date and time of TOML.
std::string date_value(CivilTime time);

}  // namespace canvoy::tools
