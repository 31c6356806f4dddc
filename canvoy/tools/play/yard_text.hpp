// Text and JSON of a charging yard (docs/json.md): events, the live table, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/worlds/charger/charging_yard.hpp"

namespace canvoy::tools {

template <>
struct WorldText<charger::ChargingYard> {
  static ReportedEvent event(const charger::YardEvent& event, const charger::ChargingYard& yard);
  /// Picture for a terminal: a line for each bay and each vehicle.
  static std::string picture(charger::ChargingYard& yard, double speed);
  static nlohmann::ordered_json snapshot(charger::ChargingYard& yard);
  static std::string summary_text(charger::ChargingYard& yard);
  static nlohmann::ordered_json summary(charger::ChargingYard& yard);
};

/// All verdicts: on the goal, then on each bay.
std::vector<Judged> judged_of(const charger::ChargingYard& yard);

}  // namespace canvoy::tools
