// A run or a log as one HTML file, to attach to a mail: images over time, verdicts, statistics,
// events, nodes, load and values. It needs no server, and loads nothing.
//
//     return write_report(world, "report.html");
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/page/live_source.hpp"

namespace canvoy::tools {

/// Number of images of a run, the first at its start and the last at its end.
inline constexpr std::size_t report_pictures = 120;
/// If there are more events, those of faults, emergencies and verdicts are kept, and the rest is
/// counted.
inline constexpr std::size_t report_events_max = 3000;

/// The data of the page. Plays the source from its position to its end, without a pause.
nlohmann::ordered_json report_json(LiveSource& source);
/// The page that shows it.
std::string report_page(const nlohmann::ordered_json& report);

/// Writes the page, and returns the result of the source. Throws Failure if it cannot be written;
/// an existing file is then unchanged.
int write_report(LiveSource& source, const std::string& path);

/// Continues the source by one of report_pictures parts, with the number of the part; false: end
/// here.
using GoOn = std::function<bool(std::size_t part)>;
/// Like write_report() above, but for a source that cannot be played from its start: from the
/// present on.
int write_report(LiveSource& source, const GoOn& go_on, const std::string& path);

}  // namespace canvoy::tools
