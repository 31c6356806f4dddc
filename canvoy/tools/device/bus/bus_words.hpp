// Text from devices of a bus (CiA 407) for people.
//
//     clock_words(ticket.time);   // "08:05"
#pragma once

#include <optional>
#include <string>

#include "canvoy/devices/cia407/kit/bus_time.hpp"

namespace canvoy::tools {

/// Text of a time; `--:--` if unknown.
std::string clock_words(const std::optional<cia407::CivilTime>& time);

}  // namespace canvoy::tools
