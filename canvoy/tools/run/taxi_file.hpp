// A taxi as a file in TOML.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/run/player.hpp"
#include "canvoy/tools/run/taxi_settings_file.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

/// A network, which knows how long it is played.
struct TaxiRun {
  taxi::TaxiOptions network{};
  std::vector<RealBus> real{};
  std::shared_ptr<const TariffParts> tariff{};  ///< null: the example's
  std::string nmea{};                           ///< the file of the drive, as it was written
};

/// Throws Failure with file and line. All of the table is looked at. Other files stand beside it,
/// in `folder`.
TaxiRun read_taxi_run(TomlTable& table, const std::string& folder);
/// A file that reads as the same, with a comment beside each value.
std::string taxi_run_text(const TaxiRun& run);

/// Adds a fault that is written as `lost-node:node=2@20min+30s`. Throws UsageError.
void add_fault(TaxiRun& run, const std::string& text);

}  // namespace canvoy::tools
