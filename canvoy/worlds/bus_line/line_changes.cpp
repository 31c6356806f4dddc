#include "canvoy/worlds/bus_line/line_changes.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace canvoy::bus_line {

namespace {

constexpr double deadhead_speed = 6.9;  ///< m/s, with lights and corners
constexpr Duration early = 1min;        ///< at the first stop
constexpr double least_way_m = 30;      ///< less is the same place

Journey* journey_of(BusLine& line, std::size_t block, std::uint32_t number) {
  auto& journeys = line.blocks[block].journeys;
  const auto found = std::ranges::find(journeys, number, &Journey::number);
  return found == journeys.end() ? nullptr : &*found;
}

std::string no_journey(std::uint32_t number) {
  return "the block has no journey " + std::to_string(number);
}

/// Index in the route of the first stop with this id or name.
std::optional<std::size_t> place_of(const BusLine& line, const BusRoute& route,
                                    const std::string& stop) {
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    const BusStop& each = line.stops[route.stops[i].stop];
    if (each.id == stop || each.name == stop) return i;
  }
  return std::nullopt;
}

/// Adds a route for one journey alone.
void give_route(BusLine& line, Journey& journey, BusRoute route) {
  route.number = std::ranges::max(line.routes, {}, &BusRoute::number).number + 1;
  journey.route = line.routes.size();
  line.routes.push_back(std::move(route));
}

/// Points of a route between two of its stops, both included.
std::vector<GeoPoint> way_between(const BusRoute& route, std::size_t first, std::size_t last) {
  const double from = route.stops[first].metres;
  const double to = route.stops[last].metres;
  std::vector<GeoPoint> points = {route.path.at(from)};
  for (std::size_t i = 0; i < route.path.points().size(); ++i) {
    const double metres = route.path.metres_of(i);
    if (metres > from && metres < to) points.push_back(route.path.points()[i]);
  }
  points.push_back(route.path.at(to));
  return points;
}

/// A link that ends at the last stop counts there, but at the border of a zone (RouteStop).
void end_last_segment(BusRoute& route) {
  RouteStop& last = route.stops.back();
  const RouteStop& before = route.stops[route.stops.size() - 2];
  if (before.fare_zone == last.fare_zone) last.route_segment = before.route_segment;
}

/// Keeps the stops from `first` to `last` of a journey.
void cut(BusLine& line, Journey& journey, std::size_t first, std::size_t last) {
  BusRoute route = line.routes[journey.route];
  const double begin = route.stops[first].metres;
  route.path = Path(way_between(route, first, last));
  route.stops = {route.stops.begin() + static_cast<std::ptrdiff_t>(first),
                 route.stops.begin() + static_cast<std::ptrdiff_t>(last) + 1};
  for (RouteStop& stop : route.stops) stop.metres -= begin;
  end_last_segment(route);
  auto& passings = journey.passings;
  passings = {passings.begin() + static_cast<std::ptrdiff_t>(first),
              passings.begin() + static_cast<std::ptrdiff_t>(last) + 1};
  passings.front().is_timing_point = true;
  give_route(line, journey, std::move(route));
}

/// A journey between the depot and a stop, without passengers.
Journey deadhead(BusLine& line, const Depot& depot, std::uint32_t number, const RouteStop& end,
                 bool is_out, Duration departure, Duration arrival) {
  const GeoPoint place = line.stops[end.stop].place;
  RouteStop stop = end;
  RouteStop garage = end;
  garage.stop = line.stops.size() - 1;
  stop.destination.clear();
  garage.destination.clear();
  BusRoute route{
      .destination = depot.sign,
      .path = Path(is_out ? std::vector{depot.place, place} : std::vector{place, depot.place})};
  route.stops = is_out ? std::vector{garage, stop} : std::vector{stop, garage};
  route.stops.front().metres = 0;
  route.stops.back().metres = route.path.metres();
  Journey journey{.number = number};
  for (const auto& [at, sequence] : {std::pair{departure, 1U}, {arrival, 2U}}) {
    journey.passings.push_back(
        {.arrival = at, .departure = at, .sequence = sequence, .boards = false, .alights = false});
  }
  give_route(line, journey, std::move(route));
  return journey;
}

}  // namespace

std::string add_depot(BusLine& line, const Depot& depot) {
  const auto way = [&](const RouteStop& stop) {
    const double metres = metres_between(line.stops[stop.stop].place, depot.place);
    return std::chrono::ceil<std::chrono::minutes>(
        std::chrono::duration<double>(metres / deadhead_speed));
  };
  std::uint32_t stop_number = 0;
  for (const BusStop& stop : line.stops) {
    stop_number = std::max(stop_number, stop.number);
    if (metres_between(stop.place, depot.place) < least_way_m) {
      return "the depot is at the stop " + stop.name;
    }
  }
  std::uint32_t number = 0;
  for (const Block& block : line.blocks) {
    const Journey& first = block.journeys.front();
    const Duration way_out = way(line.routes[first.route].stops.front());
    if (first.passings.front().departure < early + way_out) return "the depot is too far away";
    number = std::max(number, std::ranges::max(block.journeys, {}, &Journey::number).number);
  }
  line.stops.push_back({.number = stop_number + 1,
                        .id = depot.name,
                        .name = depot.name,
                        .short_name = depot.name,
                        .place = depot.place});
  for (Block& block : line.blocks) {
    const Journey& first = block.journeys.front();
    const RouteStop begin = line.routes[first.route].stops.front();
    const Duration ready = first.passings.front().departure - early;
    Journey out = deadhead(line, depot, ++number, begin, true, ready - way(begin), ready);
    block.journeys.insert(block.journeys.begin(), std::move(out));
    const Journey& last = block.journeys.back();
    const RouteStop end = line.routes[last.route].stops.back();
    const Duration done = last.passings.back().arrival + early;
    block.journeys.push_back(deadhead(line, depot, ++number, end, false, done, done + way(end)));
  }
  return "";
}

std::string turn_short(BusLine& line, std::size_t block, const ShortTurn& change) {
  Journey* const journey = journey_of(line, block, change.journey);
  if (journey == nullptr) return no_journey(change.journey);
  const auto place = place_of(line, line.routes[journey->route], change.stop);
  if (!place || *place == 0 || *place + 1 >= journey->passings.size()) {
    return "the journey does not call at '" + change.stop + "' between its ends";
  }
  const std::string name = line.stop(journey->route, *place).name;
  cut(line, *journey, 0, *place);
  BusRoute& route = line.routes[journey->route];
  route.destination = name;
  for (RouteStop& stop : route.stops) stop.destination.clear();
  auto& journeys = line.blocks[block].journeys;
  const auto next = static_cast<std::size_t>(journey - journeys.data()) + 1;
  if (next == journeys.size()) return "";
  const BusRoute& back = line.routes[journeys[next].route];
  const auto from = place_of(line, back, name);
  const bool begins_there = from && *from > 0 && *from + 1 < back.stops.size();
  if (begins_there) cut(line, journeys[next], *from, back.stops.size() - 1);
  return "";
}

std::string divert(BusLine& line, std::size_t block, const Detour& change) {
  Journey* const journey = journey_of(line, block, change.journey);
  if (journey == nullptr) return no_journey(change.journey);
  const BusRoute& whole = line.routes[journey->route];
  std::vector<std::size_t> places;
  for (const std::string& stop : change.without) {
    const auto place = place_of(line, whole, stop);
    if (!place || *place == 0 || *place + 1 >= whole.stops.size()) {
      return "the journey does not call at '" + stop + "' between its ends";
    }
    places.push_back(*place);
  }
  std::ranges::sort(places);
  if (places.empty()) return "a detour leaves out a stop";
  if (places.back() - places.front() + 1 != places.size()) {
    return "the stops of a detour follow each other";
  }
  const std::size_t before = places.front() - 1;
  const std::size_t behind = places.back() + 1;
  BusRoute route = whole;
  std::vector<GeoPoint> points = way_between(whole, 0, before);
  points.insert(points.end(), change.via.begin(), change.via.end());
  const std::vector<GeoPoint> rest = way_between(whole, behind, whole.stops.size() - 1);
  points.insert(points.end(), rest.begin(), rest.end());
  route.path = Path(points);
  const double longer =
      route.path.metres_of(points.size() - rest.size()) - whole.stops[behind].metres;
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    route.stops[i].metres += i < behind ? -whole.stops.front().metres : longer;
  }
  const auto erase = [&places](auto& all) {
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(places.front()),
              all.begin() + static_cast<std::ptrdiff_t>(places.back()) + 1);
  };
  erase(route.stops);
  erase(journey->passings);
  give_route(line, *journey, std::move(route));
  return "";
}

}  // namespace canvoy::bus_line
