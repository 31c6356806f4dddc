// A taxi in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

template <>
struct WorldText<taxi::TaxiNetwork> {
  /// `the meter is hired`
  static ToldEvent event(const taxi::TaxiEvent& event, const taxi::TaxiNetwork& network);
  /// What a terminal shows: meter, car, bus, the last events.
  static std::string picture(taxi::TaxiNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(taxi::TaxiNetwork& network);
  static std::string summary_text(taxi::TaxiNetwork& network);
  static nlohmann::ordered_json summary(taxi::TaxiNetwork& network);
};

}  // namespace canvoy::tools
