// A run or a log as one file of HTML, to attach to a mail: pictures over time, verdicts,
// statistics, events, nodes, load and values. It needs no server, and loads nothing.
//
//     return write_report(world, "report.html");
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/live/live_source.hpp"

namespace canvoy::tools {

/// Pictures of a run, the first at its start and the last at its end.
inline constexpr std::size_t report_pictures = 120;
/// Of more events, those of faults, emergencies and verdicts are kept, and the rest is counted.
inline constexpr std::size_t report_events_max = 3000;

/// What the page draws. Plays the source from where it is to its end, without a pause.
nlohmann::ordered_json report_json(LiveSource& source);
/// The page that shows it.
std::string report_page(const nlohmann::ordered_json& report);

/// Writes it, and returns what the source comes to. Throws Failure where it cannot be written:
/// then a file that was there before is as it was.
int write_report(LiveSource& source, const std::string& path);

}  // namespace canvoy::tools
