// Positions on the earth, and the straight-line distance between them.
//
//     metres_between(munich, vienna);  // 355e3 metres
#pragma once

namespace canvoy::cia447 {

/// A position.
struct GeoPosition {
  double latitude = 0;   ///< degrees, -90 (south) to 90
  double longitude = 0;  ///< degrees, -180 (west) to 180

  friend constexpr bool operator==(const GeoPosition&, const GeoPosition&) = default;
};

/// Metres along the great circle of a sphere: within 0.6 % of the distance on an ellipsoid.
double metres_between(const GeoPosition& a, const GeoPosition& b);
/// metres_between() is not less: along the meridian, less a metre for what is rounded. It takes a
/// multiplication.
double metres_at_least(const GeoPosition& a, const GeoPosition& b);

}  // namespace canvoy::cia447
