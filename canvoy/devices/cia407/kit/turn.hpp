// Directions for 6486h and 6663h (CiA 407, 9.2.15.5, 9.2.21.4), from a compass or a receiver that
// may give them below 0 or beyond a whole turn.
//
//     device.tell(compass_bearing, within_turn(degrees));
#pragma once

#include <cmath>
#include <optional>

namespace canvoy::cia407 {

inline constexpr double whole_turn = 360;  ///< degrees

/// 0 to 360 degrees; nothing for NaN.
inline std::optional<double> within_turn(std::optional<double> degrees) {
  if (!degrees || !std::isfinite(*degrees)) return std::nullopt;
  const double turned = std::fmod(*degrees, whole_turn);
  return turned < 0 ? turned + whole_turn : turned;
}

}  // namespace canvoy::cia407
