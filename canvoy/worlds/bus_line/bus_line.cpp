#include "canvoy/worlds/bus_line/bus_line.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace canvoy::bus_line {

namespace {

struct TownStop {
  const char* name;
  const char* short_name;
  GeoPoint place;
  std::uint8_t zone;
  int minutes;  ///< from the first stop
};
/// A fictitious town: in the Gulf of Guinea, near 0 degrees.
constexpr std::array<TownStop, 8> town = {{
    {"Central Station", "STATION", {0.0100, 0.0100}, 1, 0},
    {"Market Square", "MARKET", {0.0128, 0.0121}, 1, 2},
    {"Town Hall", "TOWNHALL", {0.0165, 0.0133}, 1, 4},
    {"Old Bridge", "BRIDGE", {0.0210, 0.0139}, 1, 6},
    {"School", "SCHOOL", {0.0262, 0.0165}, 2, 9},
    {"Hospital", "HOSPITAL", {0.0301, 0.0208}, 2, 11},
    {"Garden City", "GARDEN", {0.0335, 0.0262}, 2, 13},
    {"Harbour", "HARBOUR", {0.0390, 0.0310}, 2, 16},
}};
constexpr unsigned links_of_town_segment = 2;

/// Towards the harbour, or back.
BusRoute town_route(bool is_backward) {
  BusRoute route{.number = is_backward ? 2U : 1U, .is_backward = is_backward};
  std::vector<GeoPoint> points;
  for (std::size_t i = 0; i < town.size(); ++i) {
    const std::size_t place = is_backward ? town.size() - 1 - i : i;
    // Streets have corners.
    if (!points.empty()) points.push_back({town[place].place.latitude, points.back().longitude});
    points.push_back(town[place].place);
    route.stops.push_back({.stop = place, .fare_zone = town[place].zone});
  }
  route.path = Path(std::move(points));
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    route.stops[i].metres = route.path.metres_of(2 * i);
  }
  route.destination = town[route.stops.back().stop].name;
  number_segments(route, links_of_town_segment);
  return route;
}

Journey town_journey(std::uint32_t number, bool is_backward, Duration departure) {
  Journey journey{.number = number,
                  .trip = "built-in-" + std::to_string(number),
                  .route = is_backward ? 1U : 0U};
  for (std::size_t i = 0; i < town.size(); ++i) {
    const int minutes =
        is_backward ? town.back().minutes - town[town.size() - 1 - i].minutes : town[i].minutes;
    const Duration at = departure + minutes * 1min;
    journey.passings.push_back({.arrival = at,
                                .departure = at,
                                .sequence = static_cast<std::uint32_t>(i + 1),
                                .is_timing_point = i % 3 == 0});
  }
  return journey;
}

}  // namespace

void number_segments(BusRoute& route, unsigned links) {
  std::map<std::uint8_t, std::uint16_t> last;  // last number of each zone
  unsigned in_segment = 0;
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    RouteStop& stop = route.stops[i];
    const bool is_border = i == 0 || route.stops[i - 1].fare_zone != stop.fare_zone;
    const bool has_link = i + 1 < route.stops.size();
    if (is_border || (in_segment == links && has_link)) {
      ++last[stop.fare_zone];
      in_segment = 0;
    }
    stop.route_segment = last[stop.fare_zone];
    ++in_segment;
  }
}

BusLine built_in_line() {
  BusLine line{.number = 407, .id = "407", .name = "407"};
  for (std::size_t i = 0; i < town.size(); ++i) {
    line.stops.push_back({.number = static_cast<std::uint32_t>(i + 1),
                          .id = town[i].short_name,
                          .name = town[i].name,
                          .short_name = town[i].short_name,
                          .place = town[i].place});
  }
  line.routes = {town_route(false), town_route(true)};
  Block block{.number = 1, .id = "1"};
  constexpr Duration round_trip = 40min;
  std::uint32_t number = 0;
  for (Duration at = 5h; at <= 23h + 40min; at += round_trip) {
    block.journeys.push_back(town_journey(++number, false, at));
    block.journeys.push_back(town_journey(++number, true, at + round_trip / 2));
  }
  line.blocks.push_back(std::move(block));
  return line;
}

}  // namespace canvoy::bus_line
