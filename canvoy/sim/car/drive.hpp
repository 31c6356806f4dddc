// A car that is driven leg by leg: what its wheels have really turned, whatever anybody counts.
//
//     Drive drive;
//     drive.go(800, 13.9);    // 800 m at 50 km/h, and it stands
//     drive.step(100ms);
#pragma once

#include "canvoy/can/time.hpp"

namespace canvoy::car {

class Drive {
 public:
  static constexpr double acceleration = 1.5;  ///< m/s^2
  static constexpr double deceleration = 2.0;  ///< m/s^2

  /// From where it stands; `metres_per_second` is the highest speed.
  void go(double metres, double metres_per_second);
  void step(Duration time);

  bool is_standing() const { return rest_ <= 0; }
  double speed() const { return speed_; }    ///< m/s
  double metres() const { return metres_; }  ///< since the start

 private:
  double rest_ = 0;  ///< of the leg, in m
  double limit_ = 0;
  double speed_ = 0;
  double metres_ = 0;
};

}  // namespace canvoy::car
