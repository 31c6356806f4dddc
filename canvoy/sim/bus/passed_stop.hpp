// When a vehicle has passed a stop: it is beyond it, and cannot stand near it any more without hard
// braking. One rule for a simulated vehicle, one that is led by a real gateway, and the on-board
// computer that counts pulses.
//
//     has_passed_stop(2, 13.9)     // 2 m beyond it at 50 km/h: true
//     has_passed_stop(2, 3)        // it may still stand there: false
#pragma once

namespace canvoy::bus {

/// Where it stands so near to a stop with open doors, it is at the stop: drivers are not exact.
inline constexpr double near_stop_m = 30;
/// At the stop, whatever its doors do.
inline constexpr double at_stop_m = 3;
/// m/s^2: as drivers brake for a stop.
inline constexpr double gentle_braking = 0.75;

/// At `speed` m/s, `beyond` m beyond a stop (below 0: before it), at which it has not stood.
constexpr bool has_passed_stop(double beyond, double speed) {
  return beyond >= 0 && speed * speed > 2 * gentle_braking * (near_stop_m - beyond);
}

}  // namespace canvoy::bus
