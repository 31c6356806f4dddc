// Text and JSON of a police car (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/police/police_network.hpp"

namespace canvoy::tools {

template <>
struct WorldText<police::PoliceNetwork> {
  /// Text of an event: `call 961: help is wanted 6.6 km away`.
  static ReportedEvent event(const police::PoliceEvent& event,
                             const police::PoliceNetwork& network);
  /// Picture for a terminal: roof, siren, displays, radio, crew, bus, the last events.
  static std::string picture(police::PoliceNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(police::PoliceNetwork& network);
  static std::string summary_text(police::PoliceNetwork& network);
  static nlohmann::ordered_json summary(police::PoliceNetwork& network);
};

}  // namespace canvoy::tools
