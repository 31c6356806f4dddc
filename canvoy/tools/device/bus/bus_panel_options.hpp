// What the command line says of what is around a device of CiA 407 that `canvoy device` runs, but
// for its presses.
//
//     BusPanelOptions options;
//     add_bus_panel_options(command, options);
//     check_bus_options(units, options, presses);
#pragma once

#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/cia407/bus_device.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

struct BusPanelOptions {
  std::vector<std::string> segment{};        ///< words of BusSegment: `minimum`, `no-diagnostics`
  std::string png{};                         ///< of a display: the file of its picture
  std::string display = "32x4";              ///< its columns and lines
  std::vector<std::string> announcements{};  ///< `17=Town Hall`; none: it has one for every stop
  unsigned capacity = 80;                    ///< of the vehicle, of a counting manager
};

void add_bus_panel_options(Verb& command, BusPanelOptions& options);

/// Throws UsageError.
cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words);
/// Throws UsageError for what makes no sense with these units, all that there are.
void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses);

}  // namespace canvoy::tools
