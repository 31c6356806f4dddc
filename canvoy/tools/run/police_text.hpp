// A police car in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `call 961: help is wanted 6.6 km away`
ToldEvent told_event(const police::PoliceEvent& event, const police::PoliceNetwork& network);

/// What a terminal shows while the network runs: roof, siren, displays, radio, crew, bus, the last
/// events.
std::string dashboard_text(police::PoliceNetwork& network, double speed);
nlohmann::ordered_json snapshot_json(police::PoliceNetwork& network);

std::string summary_text(police::PoliceNetwork& network);
nlohmann::ordered_json summary_json(police::PoliceNetwork& network);

}  // namespace canvoy::tools
