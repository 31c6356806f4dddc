// A building with its lifts, and the network of them, as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// A network, and how long it is played.
struct LiftRun {
  Duration duration = 1h;
  lift::LiftNetworkDescription network{};
  std::vector<RealBus> real{};
  std::string arrival_list{};  ///< the file that network.arrivals are from
};

/// Files that it names are looked for in `folder`. Throws Failure with file and line. All of the
/// table is looked at.
LiftRun read_lift_run(TomlTable& table, const std::string& folder);
/// A file that reads as the same.
std::string lift_run_text(const LiftRun& run);

/// Of these faults none begins after the end of the run. Throws UsageError.
void add_lift_faults(LiftRun& run, const std::vector<std::string>& texts);

std::string_view traffic_pattern_name(lift::TrafficPattern pattern);
/// Throws UsageError.
lift::TrafficPattern parse_traffic_pattern(std::string_view name);

}  // namespace canvoy::tools
