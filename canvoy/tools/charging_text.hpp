// The network of a battery and its charger in words and as JSON: events, the live table, the
// summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/charging_network.hpp"

namespace canvoy::tools {

/// `the charger enters NMT state operational`
std::string event_text(const ChargingEvent& event, const ChargingOptions& options);
nlohmann::ordered_json event_json(const ChargingEvent& event);

/// `ampere-hours of charger and plant differ by 0.21 % (1 % allowed)`
std::string invariant_text(const Invariant& invariant, const ChargingOptions& options);
nlohmann::ordered_json invariant_json(const Invariant& invariant, const ChargingOptions& options);

/// What a terminal shows while the network runs: some twenty lines.
std::string table_text(ChargingNetwork& network, double speed);
nlohmann::ordered_json snapshot_json(const ChargingSnapshot& snapshot);

std::string summary_text(ChargingNetwork& network);
nlohmann::ordered_json summary_json(ChargingNetwork& network);

}  // namespace canvoy::tools
