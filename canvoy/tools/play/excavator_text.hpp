// Text and JSON of an excavator (docs/json.md): events, a snapshot, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "canvoy/tools/player/reported_event.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"

namespace canvoy::tools {

/// Text of an activity: `digs`.
std::string_view activity_text(excavator::Activity activity);

template <>
struct WorldText<excavator::ExcavatorNetwork> {
  /// Text of an event: `1.2 m3 of earth come to the heap, of 14.3 m3`.
  static ReportedEvent event(const excavator::ExcavatorEvent& event,
                             const excavator::ExcavatorNetwork& network);
  /// Picture for a terminal: machine, seat, bus, the last events.
  static std::string picture(excavator::ExcavatorNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(excavator::ExcavatorNetwork& network);
  static std::string summary_text(excavator::ExcavatorNetwork& network);
  static nlohmann::ordered_json summary(excavator::ExcavatorNetwork& network);
};

}  // namespace canvoy::tools
