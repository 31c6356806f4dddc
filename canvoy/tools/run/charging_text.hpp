// The network of a battery and its charger in words and as JSON (docs/json.md): events, the live
// table, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `the charger enters NMT state operational`
ToldEvent told_event(const charging::ChargingEvent& event,
                     const charging::ChargingOptions& options);

/// What a terminal shows while the network runs: some twenty lines.
std::string table_text(charging::ChargingNetwork& network, double speed);
nlohmann::ordered_json snapshot_json(charging::ChargingNetwork& network);

std::string summary_text(charging::ChargingNetwork& network);
nlohmann::ordered_json summary_json(charging::ChargingNetwork& network);

}  // namespace canvoy::tools
