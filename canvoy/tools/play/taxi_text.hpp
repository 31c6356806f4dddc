// Text and JSON of a taxi (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::tools {

template <>
struct WorldText<taxi::TaxiNetwork> {
  /// Text of an event: `the meter is hired`.
  static ReportedEvent event(const taxi::TaxiEvent& event, const taxi::TaxiNetwork& network);
  /// Picture for a terminal: meter, car, bus, the last events.
  static std::string picture(taxi::TaxiNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(taxi::TaxiNetwork& network);
  static std::string summary_text(taxi::TaxiNetwork& network);
  static nlohmann::ordered_json summary(taxi::TaxiNetwork& network);
};

}  // namespace canvoy::tools
