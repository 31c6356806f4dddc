#include "canvoy/worlds/bus_line/route_match.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::bus_line {

namespace {

/// A position may be a second old.
constexpr double met_m = 25;
/// Of two places, the one that is nearer to the position by this distance is right.
constexpr double nearer_m = 20;
/// A place that positions have met for this much longer than another one is right.
constexpr double ahead_m = 50;
/// A place that was met for this distance before, while another was not, is right.
constexpr double met_before_m = 40;

}  // namespace

void RouteMatch::take(const Path& path, const GeoPoint& fix, double odometer) {
  std::erase_if(places_, [&](const Place& place) {
    return metres_between(path.at(place.at(odometer)), fix) > met_m;
  });
  double least = off_route_m;
  const auto away = [&](double metres) { return metres_between(path.at(metres), fix); };
  std::vector<double> near = path.places_near(fix, off_route_m);
  for (const double metres : near) least = std::min(least, away(metres));
  std::erase_if(near, [&](double metres) { return away(metres) > least + nearer_m; });
  for (const double metres : near) {
    const bool is_known = std::ranges::any_of(places_, [&](const Place& place) {
      return std::abs(place.at(odometer) - metres) < met_before_m;
    });
    if (!is_known) places_.push_back({metres, odometer});
  }
}

std::optional<double> RouteMatch::metres(double odometer, double confirmed) const {
  if (places_.empty()) return std::nullopt;
  const auto best = std::ranges::min_element(places_, {}, &Place::odometer);
  const bool has_rival = std::ranges::any_of(places_, [&](const Place& place) {
    return &place != &*best && place.odometer < best->odometer + ahead_m;
  });
  if (has_rival || odometer - best->odometer < confirmed) return std::nullopt;
  return best->at(odometer);
}

}  // namespace canvoy::bus_line
