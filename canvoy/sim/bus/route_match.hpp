// Where on a route a vehicle can be, by positions of satellites and pulses of the wheels: each
// place where the route goes by the first position is possible. Those that the next ones do not
// meet, driven as far as the wheels have turned, are given up: so which half of a street that is
// driven there and back, and whether it drives along the route at all.
//
//     RouteMatch match;
//     match.take(route.path, fix, odometer);
//     if (const auto metres = match.metres(odometer, 0)) ...    // the only place where it can be
#pragma once

#include <optional>
#include <vector>

#include "canvoy/sim/bus/path.hpp"

namespace canvoy::bus {

class RouteMatch {
 public:
  /// Farther from its route it is elsewhere.
  static constexpr double off_route_m = 60;

  /// No position was told yet.
  void forget() { places_.clear(); }
  /// A position, told where the odometer said `odometer`.
  void take(const Path& path, const GeoPoint& fix, double odometer);
  /// How far along the route it is. Nothing: there is no place, or another one that is as likely,
  /// or it was not met for `confirmed` m.
  std::optional<double> metres(double odometer, double confirmed) const;

 private:
  struct Place {
    double metres = 0;    ///< along the route, where the first position was
    double odometer = 0;  ///< there; since then positions have met it

    double at(double now) const { return metres + now - odometer; }
  };

  std::vector<Place> places_;
};

}  // namespace canvoy::bus
