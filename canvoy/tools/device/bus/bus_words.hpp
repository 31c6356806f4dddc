// What devices of a bus (CiA 407) tell people, in words.
//
//     clock_words(ticket.time);   // "08:05"
#pragma once

#include <optional>
#include <string>

#include "canvoy/devices/cia407/bus_time.hpp"

namespace canvoy::tools {

/// `--:--` where it is not known.
std::string clock_words(const std::optional<cia407::CivilTime>& time);

}  // namespace canvoy::tools
