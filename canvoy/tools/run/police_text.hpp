// A police car in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

template <>
struct WorldText<police::PoliceNetwork> {
  /// `call 961: help is wanted 6.6 km away`
  static ToldEvent event(const police::PoliceEvent& event, const police::PoliceNetwork& network);
  /// What a terminal shows: roof, siren, displays, radio, crew, bus, the last events.
  static std::string picture(police::PoliceNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(police::PoliceNetwork& network);
  static std::string summary_text(police::PoliceNetwork& network);
  static nlohmann::ordered_json summary(police::PoliceNetwork& network);
};

}  // namespace canvoy::tools
