// A police car as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// A network, which knows how long it is played.
struct PoliceRun {
  police::PoliceOptions network{};
  std::vector<RealBus> real{};
};

/// Throws Failure with file and line. All of the table is looked at.
PoliceRun read_police_run(TomlTable& table);
/// A file that reads as the same, with a comment beside each value.
std::string police_run_text(const PoliceRun& run);

/// Adds a fault that is written as `lost-node:node=2@20min+30s`. Throws UsageError.
void add_fault(PoliceRun& run, const std::string& text);

}  // namespace canvoy::tools
