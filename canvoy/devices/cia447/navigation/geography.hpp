// Positions on the earth, and how far one is from the other as the crow flies.
//
//     metres_between(munich, vienna);  // 355e3 metres
#pragma once

namespace canvoy::cia447 {

struct GeoPosition {
  double latitude = 0;   ///< degrees, -90 (south) to 90
  double longitude = 0;  ///< degrees, -180 (west) to 180

  friend constexpr bool operator==(const GeoPosition&, const GeoPosition&) = default;
};

/// Metres along the great circle of a sphere: within 0.6 % of what an ellipsoid gives.
double metres_between(const GeoPosition& a, const GeoPosition& b);

}  // namespace canvoy::cia447
