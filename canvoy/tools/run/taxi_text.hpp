// A taxi in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `the meter is hired`
ToldEvent told_event(const taxi::TaxiEvent& event, const taxi::TaxiNetwork& network);

/// What a terminal shows while the network runs: meter, car, bus, the last events.
std::string dashboard_text(taxi::TaxiNetwork& network, double speed);
nlohmann::ordered_json snapshot_json(taxi::TaxiNetwork& network);

std::string summary_text(taxi::TaxiNetwork& network);
nlohmann::ordered_json summary_json(taxi::TaxiNetwork& network);

}  // namespace canvoy::tools
