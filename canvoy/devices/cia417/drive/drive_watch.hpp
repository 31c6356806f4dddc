// Monitors the car of a drive: its speed, its standstill with the closed brake, and its following
// of the control loop (CiA 417-4, 4.11; CiA 402, following error).
//
//     DriveWatch watch({.overspeed_percent = 115});
//     if (watch.is_too_fast(car, parameters)) ...
#pragma once

#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

/// Widths are units of position.
struct DriveWatchLimits {
  double overspeed_percent = 115;
  double unintended_distance = 50;
  double following_window = 200;
  Duration following_time = 200ms;
};

class DriveWatch {
 public:
  explicit DriveWatch(const DriveWatchLimits& limits) : limits_(limits) {}

  void begin_anew() { behind_.begin_anew(); }
  bool is_too_fast(const DrivenCar& car, const DriveParameters& parameters) const;
  /// True if it stood with the closed brake, and moves.
  bool strays(const DrivenCar& car, const DriveParameters& parameters) const;
  /// True if it lags for longer than allowed. Call it every period.
  bool lags_behind(const DrivenCar& car, const DriveParameters& parameters, Time now);

 private:
  DriveWatchLimits limits_;
  Lasting behind_;
};

}  // namespace canvoy::cia417
