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
  double overspeed_percent = 115;   ///< of 6408h:01h
  double unintended_distance = 50;  ///< while it has to stand
  double following_window = 200;    ///< from the demanded position
  Duration following_time = 200ms;  ///< beyond the window: a fault
};

class DriveWatch {
 public:
  /// Makes a watch; nothing has lagged so far.
  explicit DriveWatch(const DriveWatchLimits& limits) : limits_(limits) {}

  /// Starts again, after a reset.
  void begin_anew() { behind_.begin_anew(); }
  /// True above the limit of overspeed.
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
