#include "canvoy/tools/play/bus_words.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

std::string BusNames::device(BusIndex, NodeId id) const {
  if (id == 0) return "all";
  return name(id).empty() ? text::node_text(id) : fmt::format("{} ({})", name(id), id);
}

std::string service_text(const bus_line::BusNetworkStatistics& statistics,
                         const bus_line::RiderStatistics& riders, double odometer,
                         const BusSnapshot& bus) {
  constexpr double metres_a_km = 1000;
  constexpr double percent = 100;
  const bus_line::Headways& headways = statistics.headways;
  std::string follows;
  if (headways.count() > 0) {
    follows = fmt::format("; headways vary by {:.0f} %, {:.0f} % bunched",
                          percent * headways.variation(), percent * headways.bunched());
  }
  return fmt::format(
      "{} journeys, {} stops, {:.1f} km; {} people in, {} out, {} left behind; {} tickets printed, "
      "{} cancelled; {} texts shown, {} stops announced; at most {} s late{}; {} frames, {} "
      "error frames",
      statistics.journeys, statistics.stops, odometer / metres_a_km, riders.in, riders.out,
      riders.left_behind, riders.bought, riders.cancelled, statistics.texts, statistics.announced,
      std::chrono::floor<std::chrono::seconds>(statistics.worst_delay).count(), follows, bus.frames,
      bus.error_frames);
}

Json bus_statistics_json(const bus_line::BusNetworkStatistics& statistics,
                         const bus_line::RiderStatistics& riders) {
  Json json = {{"journeys", statistics.journeys},
               {"stops", statistics.stops},
               {"announced", statistics.announced},
               {"texts", statistics.texts},
               {"in", riders.in},
               {"out", riders.out},
               {"left_behind", riders.left_behind},
               {"carried_past", riders.carried_past},
               {"tickets_printed", riders.bought},
               {"tickets_cancelled", riders.cancelled},
               {"without_ticket", riders.without_ticket},
               {"worst_delay_s", in_seconds(statistics.worst_delay)}};
  const bus_line::Headways& headways = statistics.headways;
  if (headways.count() == 0) return json;
  json["headways"] = {{"count", headways.count()},
                      {"variation", headways.variation()},
                      {"bunched", headways.bunched()}};
  return json;
}

}  // namespace canvoy::tools
