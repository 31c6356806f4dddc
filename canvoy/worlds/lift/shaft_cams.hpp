// Positions of the cams of a simulated shaft, for its position CAM unit (63A0h to 63A2h): the
// profile has objects for their states, and none for their positions (CiA 417-4, 4.10).
//
//     const auto cams = cams_of_shaft(heights_m, {.door_zone_m = 0.2, .speed_m_s = 1.6});
//     CarPositionDevice<> position(port, 4, hardware, {.cams = cams});
#pragma once

#include <span>
#include <vector>

#include "canvoy/devices/cia417/position/position_cam_unit.hpp"

namespace canvoy::lift {

/// Dimensions from which the cams follow.
struct ShaftCamDesign {
  double door_zone_m = 0.2;        ///< to both sides of a floor
  double speed_m_s = 1.6;          ///< rated speed
  double acceleration_m_s2 = 1.0;  ///< of braking before the last floors
  double jerk_m_s3 = 1.2;          ///< greatest change of the acceleration
};

/// Cams of channel 1, each a bit of 63A0h:01h.
enum class ShaftCam : std::uint8_t {
  door_zone = 1,      ///< of any floor: bit 0
  lowest_floor = 2,   ///< its door zone, and below
  highest_floor = 3,  ///< its door zone, and above
  slow_down_low = 4,  ///< a car that goes down here at its rated speed must slow down
  slow_down_high = 5,
};

/// `heights_m` are the heights of the floors, rising, and at least one.
inline std::vector<cia417::Cam> cams_of_shaft(std::span<const double> heights_m,
                                              const ShaftCamDesign& design) {
  constexpr double far_mm = 1e7;
  constexpr double hysteresis_mm = 2;
  std::vector<cia417::Cam> cams;
  const auto add = [&cams](ShaftCam number, double low_mm, double high_mm) {
    cams.push_back({.number = static_cast<std::uint8_t>(number),
                    .low = low_mm,
                    .high = high_mm,
                    .hysteresis = hysteresis_mm});
  };
  const double zone = design.door_zone_m * 1000;
  const double bottom = heights_m.front() * 1000;
  const double top = heights_m.back() * 1000;
  // Half of the time that it takes to stop from the rated speed.
  const double to_stop =
      design.speed_m_s * 1000 / 2 *
      (design.speed_m_s / design.acceleration_m_s2 + design.acceleration_m_s2 / design.jerk_m_s3);
  for (const double height : heights_m) {
    add(ShaftCam::door_zone, height * 1000 - zone, height * 1000 + zone);
  }
  add(ShaftCam::lowest_floor, -far_mm, bottom + zone);
  add(ShaftCam::highest_floor, top - zone, far_mm);
  add(ShaftCam::slow_down_low, -far_mm, bottom + to_stop);
  add(ShaftCam::slow_down_high, top - to_stop, far_mm);
  return cams;
}

}  // namespace canvoy::lift
