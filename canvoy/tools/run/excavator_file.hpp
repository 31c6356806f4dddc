// An excavator as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/excavator/excavator_network.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// A network, which knows how long it is played.
struct ExcavatorRun {
  excavator::ExcavatorOptions network{};
  std::vector<RealBus> real{};
  std::string shift{};  ///< the file of a recorded one; empty: there is none
};

/// Throws Failure with file and line. All of the table is looked at. Paths in it are relative to
/// `folder`.
ExcavatorRun read_excavator_run(TomlTable& table, const std::string& folder);
/// A file that reads as the same, with a comment beside each value.
std::string excavator_run_text(const ExcavatorRun& run);

/// Has the shift of a file played again. Throws Failure.
void choose_shift(ExcavatorRun& run, const std::string& path);
/// Adds a fault that is written as `stuck-axis:axis=4@20min+30s`. Throws UsageError.
void add_fault(ExcavatorRun& run, const std::string& text);

}  // namespace canvoy::tools
