// Clock changes of a time zone, from the time zone database of the system (package tzdata).
//
//     const auto changes = offsets_of("Europe/Berlin", sys_days(date), std::chrono::days(400));
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/worlds/bus_line/local_clock.hpp"

namespace canvoy::tools {

/// Offsets from `first` on for `days`, accurate to a second; the first one applies at `first`.
/// Nothing: no such name in the database. Temporarily changes the environment of the process (TZ),
/// so no other thread may run.
std::optional<std::vector<bus_line::OffsetChange>> offsets_of(const std::string& zone,
                                                              std::chrono::sys_days first,
                                                              std::chrono::days days);

}  // namespace canvoy::tools
