// When clocks are set somewhere, by the system's database of time zones (package tzdata).
//
//     const auto changes = offsets_of("Europe/Berlin", sys_days(date), std::chrono::days(400));
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/sim/bus/local_clock.hpp"

namespace canvoy::tools {

/// Offsets from `first` on for `days`, to a second; the first one holds at `first`. Nothing: the
/// database has no such name. For a short time it changes the environment of the process (TZ): not
/// while there are other threads.
std::optional<std::vector<bus::OffsetChange>> offsets_of(const std::string& zone,
                                                         std::chrono::sys_days first,
                                                         std::chrono::days days);

}  // namespace canvoy::tools
