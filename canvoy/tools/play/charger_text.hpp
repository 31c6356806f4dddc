// Text and JSON of the network of a battery and its charger (docs/json.md): events, the live table,
// the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

namespace canvoy::tools {

template <>
struct WorldText<charger::ChargerNetwork> {
  /// Text of an event: `the charger enters NMT state operational`.
  static ReportedEvent event(const charger::ChargerEvent& event,
                             const charger::ChargerNetwork& network);
  /// Picture for a terminal: about twenty lines.
  static std::string picture(charger::ChargerNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(charger::ChargerNetwork& network);
  static std::string summary_text(charger::ChargerNetwork& network);
  static nlohmann::ordered_json summary(charger::ChargerNetwork& network);
};

}  // namespace canvoy::tools
