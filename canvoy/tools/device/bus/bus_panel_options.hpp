// Options of the command line for the surroundings of a device of CiA 407 that `canvoy device`
// runs, except presses.
//
//     BusPanelOptions options;
//     add_bus_panel_options(command, options);
//     check_bus_options(units, options, presses);
#pragma once

#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

struct BusPanelOptions {
  std::vector<std::string> segment{};        ///< words of BusSegment: `minimum`, `no-diagnostics`
  std::string png{};                         ///< of a display: the picture file
  std::string display = "32x4";              ///< columns and lines of the display
  std::vector<std::string> announcements{};  ///< `17=Town Hall`; empty: one for every stop
  unsigned capacity = 80;  ///< capacity of the vehicle in passengers, for a counting manager
};

void add_bus_panel_options(Verb& command, BusPanelOptions& options);

/// Throws UsageError.
cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words);
/// Throws UsageError for an option that does not apply to these units, which are all units of the
/// device.
void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses);

}  // namespace canvoy::tools
