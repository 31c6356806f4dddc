// Decides when a vehicle has passed a stop: it is beyond the stop, and cannot stand near it without
// hard braking. The rule is common to a simulated vehicle, one that follows a real gateway, and the
// on-board computer that counts pulses.
//
//     has_passed_stop(2, 13.9)     // 2 m beyond it at 50 km/h: true
//     has_passed_stop(2, 3)        // it may still stand there: false
#pragma once

namespace canvoy::bus_line {

/// Distance in m within which a vehicle with open doors is at the stop: drivers are not exact.
inline constexpr double near_stop_m = 30;
/// Distance in m within which a vehicle is at the stop, whatever its doors do.
inline constexpr double at_stop_m = 3;
/// m/s^2: usual braking for a stop.
inline constexpr double gentle_braking = 0.75;

/// True for a vehicle at `speed` m/s, `beyond` m beyond a stop (below 0: before it), at which it
/// has not stood.
constexpr bool has_passed_stop(double beyond, double speed) {
  return beyond >= 0 && speed * speed > 2 * gentle_braking * (near_stop_m - beyond);
}

}  // namespace canvoy::bus_line
