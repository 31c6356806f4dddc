// A bus in words and as JSON (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

template <>
struct WorldText<bus::BusNetwork> {
  /// `stop: arrives at Town Hall, 32 s late, 12 aboard`
  static ToldEvent event(const bus::NetworkEvent& event, const bus::BusNetwork& network);
  /// What a terminal shows: displays as they look, the line with the vehicle on it, bus, the last
  /// events.
  static std::string picture(bus::BusNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(bus::BusNetwork& network);
  static std::string summary_text(bus::BusNetwork& network);
  static nlohmann::ordered_json summary(bus::BusNetwork& network);
};

}  // namespace canvoy::tools
