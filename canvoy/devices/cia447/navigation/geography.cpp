#include "canvoy/devices/cia447/navigation/geography.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace canvoy::cia447 {

namespace {

constexpr double earth_radius = 6'371'008.8;
constexpr double radian = std::numbers::pi / 180;

}  // namespace

double metres_at_least(const GeoPosition& a, const GeoPosition& b) {
  return std::abs(b.latitude - a.latitude) * (earth_radius * radian) - 1;
}

double metres_between(const GeoPosition& a, const GeoPosition& b) {
  const double north = std::sin((b.latitude - a.latitude) * radian / 2);
  const double east = std::sin((b.longitude - a.longitude) * radian / 2);
  // Haversines keep their precision when the two are near each other.
  const double half_chord =
      north * north + std::cos(a.latitude * radian) * std::cos(b.latitude * radian) * east * east;
  return 2 * earth_radius * std::asin(std::sqrt(std::min(1.0, half_chord)));
}

}  // namespace canvoy::cia447
