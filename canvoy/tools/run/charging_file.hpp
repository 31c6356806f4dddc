// The network of a battery and its charger as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// A network, and how long it is played.
struct ChargingRun {
  Duration duration = 8h;
  charging::ChargingOptions network{};
  std::vector<RealBus> real{};
};

/// That of `canvoy run charger`.
ChargingRun default_charging_run();

/// Throws Failure with file and line. All of the table is looked at.
ChargingRun read_charging_run(TomlTable& table);
/// A file that reads as the same, with a comment beside each value.
std::string charging_run_text(const ChargingRun& run);

/// Adds a fault that is written as `heartbeat-loss@20min+30s`. Throws UsageError.
void add_fault(ChargingRun& run, const std::string& text);

}  // namespace canvoy::tools
