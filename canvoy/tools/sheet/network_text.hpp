// Values in the notation of a network file.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::tools {

/// A quoted text.
std::string text_value(std::string_view text);
/// A local date and time of TOML.
std::string date_value(CivilTime time);

}  // namespace canvoy::tools
