// Finds where on a route a vehicle can be, by positions of satellites and pulses of the wheels.
// Each place where the route passes the first position is possible. Places that later positions do
// not meet, after the distance that the wheels have turned, are given up. This decides which half
// of a street that is driven there and back, and whether the vehicle drives along the route at all.
//
//     RouteMatch match;
//     match.take(route.path, fix, odometer);
//     if (const auto metres = match.metres(odometer, 0)) ...    // the only place where it can be
#pragma once

#include <optional>
#include <vector>

#include "canvoy/worlds/bus_line/path.hpp"

namespace canvoy::bus_line {

class RouteMatch {
 public:
  /// Distance in m beyond which a vehicle is off its route.
  static constexpr double off_route_m = 60;

  /// Forgets all positions.
  void forget() { places_.clear(); }
  /// Takes a position, received when the odometer was at `odometer`.
  void take(const Path& path, const GeoPoint& fix, double odometer);
  /// Distance along the route. Empty: there is no place, or several that are as likely, or it was
  /// not met for `confirmed` m.
  std::optional<double> metres(double odometer, double confirmed) const;

 private:
  struct Place {
    double metres = 0;    ///< along the route, at the first position
    double odometer = 0;  ///< at the first position; later positions have met the place since

    double at(double now) const { return metres + now - odometer; }
  };

  std::vector<Place> places_;
};

}  // namespace canvoy::bus_line
