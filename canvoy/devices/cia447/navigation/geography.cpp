#include "canvoy/devices/cia447/navigation/geography.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace canvoy::cia447 {

double metres_between(const GeoPosition& a, const GeoPosition& b) {
  constexpr double earth_radius = 6'371'008.8;
  constexpr double radian = std::numbers::pi / 180;
  const double north = std::sin((b.latitude - a.latitude) * radian / 2);
  const double east = std::sin((b.longitude - a.longitude) * radian / 2);
  // Haversines, which keep their digits where the two are near each other.
  const double half_chord =
      north * north + std::cos(a.latitude * radian) * std::cos(b.latitude * radian) * east * east;
  return 2 * earth_radius * std::asin(std::sqrt(std::min(1.0, half_chord)));
}

}  // namespace canvoy::cia447
