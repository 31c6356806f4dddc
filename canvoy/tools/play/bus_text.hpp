// Text and JSON of a bus (docs/json.md): events, the dashboard, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::tools {

template <>
struct WorldText<bus_line::BusNetwork> {
  /// Text of an event: `stop: arrives at Town Hall, 32 s late, 12 aboard`.
  static ReportedEvent event(const bus_line::NetworkEvent& event,
                             const bus_line::BusNetwork& network);
  /// Picture for a terminal: displays, the line with the vehicle, bus, the last events.
  static std::string picture(bus_line::BusNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(bus_line::BusNetwork& network);
  static std::string summary_text(bus_line::BusNetwork& network);
  static nlohmann::ordered_json summary(bus_line::BusNetwork& network);
};

}  // namespace canvoy::tools
