#include "canvoy/worlds/bus_line/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace canvoy::bus_line {

namespace {

constexpr double earth_radius_m = 6'371'008.8;

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

}  // namespace

double metres_between(const GeoPoint& a, const GeoPoint& b) {
  const double north = std::sin(radians(b.latitude - a.latitude) / 2);
  const double east = std::sin(radians(b.longitude - a.longitude) / 2);
  const double half_chord =
      north * north + std::cos(radians(a.latitude)) * std::cos(radians(b.latitude)) * east * east;
  return 2 * earth_radius_m * std::asin(std::sqrt(std::min(half_chord, 1.0)));
}

double heading(const GeoPoint& from, const GeoPoint& to) {
  const double way = radians(to.longitude - from.longitude);
  const double a = radians(from.latitude);
  const double b = radians(to.latitude);
  const double east = std::sin(way) * std::cos(b);
  const double north = std::cos(a) * std::sin(b) - std::sin(a) * std::cos(b) * std::cos(way);
  if (east == 0 && north == 0) return 0;
  const double degrees = std::atan2(east, north) * 180 / std::numbers::pi;
  return degrees < 0 ? std::fmod(degrees + 360, 360) : degrees;
}

GeoPoint between(const GeoPoint& a, const GeoPoint& b, double share) {
  return {a.latitude + (b.latitude - a.latitude) * share,
          a.longitude + (b.longitude - a.longitude) * share};
}

Path::Path(std::vector<GeoPoint> points) : points_(std::move(points)) {
  double metres = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) metres += metres_between(points_[i - 1], points_[i]);
    metres_.push_back(metres);
  }
}

std::size_t Path::piece_at(double metres) const {
  const auto above = std::upper_bound(metres_.begin(), metres_.end(), metres);
  const auto place = static_cast<std::size_t>(above - metres_.begin());
  return std::clamp<std::size_t>(place, 1, points_.size() - 1) - 1;
}

GeoPoint Path::at(double metres) const {
  if (points_.empty()) return {};
  if (points_.size() == 1) return points_.front();
  const std::size_t piece = piece_at(metres);
  const double length = metres_[piece + 1] - metres_[piece];
  if (length <= 0) return points_[piece];
  const double share = std::clamp((metres - metres_[piece]) / length, 0.0, 1.0);
  return between(points_[piece], points_[piece + 1], share);
}

/// At this scale the earth is flat.
Path::Foot Path::foot_on(std::size_t piece, const GeoPoint& point) const {
  const double narrowing = std::cos(radians(point.latitude));
  const GeoPoint& from = points_[piece];
  const double east = (points_[piece + 1].longitude - from.longitude) * narrowing;
  const double north = points_[piece + 1].latitude - from.latitude;
  const double to_east = (point.longitude - from.longitude) * narrowing;
  const double to_north = point.latitude - from.latitude;
  const double square = east * east + north * north;
  const double share =
      square > 0 ? std::clamp((to_east * east + to_north * north) / square, 0.0, 1.0) : 0;
  return {.metres = metres_[piece] + share * (metres_[piece + 1] - metres_[piece]),
          .away = std::hypot(to_east - share * east, to_north - share * north)};
}

double Path::nearest_to(const GeoPoint& point) const {
  Foot nearest{.away = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Foot foot = foot_on(i, point);
    if (foot.away < nearest.away) nearest = foot;
  }
  return nearest.metres;
}

/// Two places count as one where the path between them stays near the point.
std::vector<double> Path::places_near(const GeoPoint& point, double within) const {
  constexpr double goes_away_m = 15;
  const double metres_a_degree = radians(earth_radius_m);
  std::vector<Foot> feet;
  double farthest = 0;  // distance of the farthest corner since the last foot
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    farthest = std::max(farthest, metres_between(points_[i], point));
    Foot foot = foot_on(i, point);
    foot.away *= metres_a_degree;
    if (foot.away > within) continue;
    const bool is_other =
        feet.empty() || farthest > std::max(foot.away, feet.back().away) + goes_away_m;
    if (is_other) {
      feet.push_back(foot);
    } else if (foot.away < feet.back().away) {
      feet.back() = foot;
    } else {
      continue;
    }
    farthest = 0;
  }
  std::vector<double> places;
  for (const Foot& foot : feet) places.push_back(foot.metres);
  return places;
}

double Path::heading_at(double metres) const {
  if (points_.size() < 2) return 0;
  const std::size_t piece = piece_at(metres);
  return heading(points_[piece], points_[piece + 1]);
}

}  // namespace canvoy::bus_line
