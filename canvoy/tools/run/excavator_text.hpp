// An excavator in words and as JSON (docs/json.md): events, a look, the summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "canvoy/sim/excavator/excavator_network.hpp"
#include "canvoy/tools/run/told_event.hpp"

namespace canvoy::tools {

/// `digs`
std::string_view activity_text(excavator::Activity activity);

template <>
struct WorldText<excavator::ExcavatorNetwork> {
  /// `1.2 m3 of earth come to the heap, of 14.3 m3`
  static ToldEvent event(const excavator::ExcavatorEvent& event,
                         const excavator::ExcavatorNetwork& network);
  /// What a terminal shows: machine, seat, bus, the last events.
  static std::string picture(excavator::ExcavatorNetwork& network, double speed);
  static nlohmann::ordered_json snapshot(excavator::ExcavatorNetwork& network);
  static std::string summary_text(excavator::ExcavatorNetwork& network);
  static nlohmann::ordered_json summary(excavator::ExcavatorNetwork& network);
};

}  // namespace canvoy::tools
