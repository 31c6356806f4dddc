// A path over the ground: points on the earth, and the distance of each along it.
//
//     const Path path({{50.1, 8.5}, {50.11, 8.51}});
//     path.at(120).latitude;      // 120 m from its start
#pragma once

#include <cstddef>
#include <vector>

namespace canvoy::bus_line {

/// WGS 84, in degrees.
struct GeoPoint {
  double latitude = 0;   ///< north is positive
  double longitude = 0;  ///< east is positive

  friend bool operator==(const GeoPoint&, const GeoPoint&) = default;
};

/// Distance along the great circle, on a sphere of the earth's mean radius: off by at most 0.5 %.
double metres_between(const GeoPoint& a, const GeoPoint& b);
/// Heading from north, clockwise, 0 to below 360 degrees; 0 where both points are the same.
double heading(const GeoPoint& from, const GeoPoint& to);
/// Point at `share` of the way from a to b, for points a few kilometres apart.
GeoPoint between(const GeoPoint& a, const GeoPoint& b, double share);

class Path {
 public:
  Path() = default;
  /// Measures the distances between the points, in their order.
  explicit Path(std::vector<GeoPoint> points);

  /// Length of the path.
  double metres() const { return metres_.empty() ? 0 : metres_.back(); }
  /// Points as given.
  const std::vector<GeoPoint>& points() const { return points_; }
  /// Distance of a point along the path, by its index in points().
  double metres_of(std::size_t point) const { return metres_[point]; }
  /// Point at a distance along the path; beyond an end: that end. Logarithmic in the number of
  /// points.
  GeoPoint at(double metres) const;
  /// Degrees clockwise from north of the piece at a distance; 0 with fewer than two points.
  double heading_at(double metres) const;
  /// Distance along the path of its position nearest to a point; of several the first, 0 where
  /// there are no points. Linear in the number of points.
  double nearest_to(const GeoPoint& point) const;
  /// Distances along the path where it passes a point at most `within` m away, in rising order: two
  /// for a street that is driven there and back. Linear in the number of points.
  std::vector<double> places_near(const GeoPoint& point, double within) const;

 private:
  /// Index of the piece at a distance, by its first point.
  std::size_t piece_at(double metres) const;
  /// Position on a piece that is nearest to a point.
  struct Foot {
    double metres = 0;  ///< along the path
    double away = 0;    ///< m from the point
  };
  Foot foot_on(std::size_t piece, const GeoPoint& point) const;

  std::vector<GeoPoint> points_;
  std::vector<double> metres_;
};

}  // namespace canvoy::bus_line
