// A bus as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// Where a timetable is taken from; an empty feed: the built-in line.
struct LineChoice {
  std::string feed{};       ///< a folder or a zip archive of GTFS
  std::string route{};      ///< route_id, or the only one of this short name
  std::string date{};       ///< `2026-11-23`; empty: a Monday, for the built-in line
  std::uint32_t block = 1;  ///< which of the line's, by its number
};

/// A network, which knows how long it is played.
struct BusRun {
  bus::BusNetworkOptions network{};
  LineChoice line{};
  std::vector<RealBus> real{};
};

/// Reads the feed where one is chosen, and chooses the block. A feed without a date is played on
/// the first day on which its route runs. Throws Failure.
void choose_line(BusRun& run, const LineChoice& line);
/// A run with nothing else chosen.
BusRun run_on_line(const LineChoice& line);

/// `folder`: of the file, to which its paths are relative. Throws Failure with file and line. All
/// of the table is looked at.
BusRun read_bus_run(TomlTable& table, const std::string& folder);
/// A file that reads as the same, with a comment beside each value.
std::string bus_run_text(const BusRun& run);

/// Adds a fault that is written as `lost-node:node=5@20min+30s`. Throws UsageError.
void add_fault(BusRun& run, const std::string& text);

}  // namespace canvoy::tools
