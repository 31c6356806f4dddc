// The network of a battery and its charger in words and as JSON (docs/json.md): events, the live
// table, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

template <>
struct WorldText<charging::ChargingNetwork> {
  /// `the charger enters NMT state operational`
  static ToldEvent event(const charging::ChargingEvent& event,
                         const charging::ChargingNetwork& network);
  /// What a terminal shows: some twenty lines.
  static std::string picture(charging::ChargingNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(charging::ChargingNetwork& network);
  static std::string summary_text(charging::ChargingNetwork& network);
  static nlohmann::ordered_json summary(charging::ChargingNetwork& network);
};

}  // namespace canvoy::tools
