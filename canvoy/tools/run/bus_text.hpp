// A bus in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `stop: arrives at Town Hall, 32 s late, 12 aboard`
ToldEvent told_event(const bus::NetworkEvent& event, const bus::BusNetwork& network);

/// What a terminal shows while the network runs: displays as they look, the line with the vehicle
/// on it, bus, the last events.
std::string dashboard_text(bus::BusNetwork& network, double speed);
nlohmann::ordered_json snapshot_json(bus::BusNetwork& network);

std::string summary_text(bus::BusNetwork& network);
nlohmann::ordered_json summary_json(bus::BusNetwork& network);

}  // namespace canvoy::tools
