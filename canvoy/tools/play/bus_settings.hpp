// Parts of the file of a bus: its devices, messages, displays, doors and passengers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/tools/play/world_file.hpp"
#include "canvoy/worlds/bus_line/bus_network_options.hpp"
#include "canvoy/worlds/bus_line/line_changes.hpp"

namespace canvoy::tools {

/// Source of a timetable; an empty feed: the built-in line.
struct LineChoice {
  std::string feed{};       ///< a folder or a zip archive of GTFS
  std::string route{};      ///< route_id, or a unique short name
  std::string date{};       ///< `2026-11-23`; empty: a Monday, for the built-in line
  std::uint32_t block = 1;  ///< number of a block of the line
};

struct BusRun : WorldRun {
  bus_line::BusNetworkOptions network{};
  LineChoice line{};
  std::string demand{};  ///< its file name, as given
  std::string delays{};  ///< likewise
  std::optional<bus_line::Depot> depot{};
  std::vector<bus_line::ShortTurn> short_turns{};
  std::vector<bus_line::Detour> detours{};
};

/// A table of a car: those of the third and fourth are written where the bus has that car.
FilePart<BusRun> part_of_car(unsigned car, FilePart<BusRun> part);
/// Adds `[[short_turn]]`, `[[detour]]`, `[depot]` and `[[driver]]`. The line must be read before.
/// The depot comes last of those that change the line: its journeys are beside all others.
void add_line_changes(std::vector<FilePart<BusRun>>& parts);
/// Adds what add_line_changes() adds, `[vehicle]`, `[passengers]`, `[messages]`, a table for each
/// device of the bus, and
/// `[[device]]` for others. File names are relative to `folder`; the line must be read before.
void add_bus_settings(std::vector<FilePart<BusRun>>& parts, const std::string& folder);

}  // namespace canvoy::tools
