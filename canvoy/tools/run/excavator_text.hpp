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

/// `1.2 m3 of earth come to the heap, of 14.3 m3`
ToldEvent told_event(const excavator::ExcavatorEvent& event,
                     const excavator::ExcavatorNetwork& network);

nlohmann::ordered_json snapshot_json(excavator::ExcavatorNetwork& network);

std::string summary_text(excavator::ExcavatorNetwork& network);
nlohmann::ordered_json summary_json(excavator::ExcavatorNetwork& network);

}  // namespace canvoy::tools
