// What the wheels of a bus do: it drives along a path to where it shall stand, as fast as it may
// and no harder than passengers can stand.
//
//     BusDrive drive;
//     drive.begin(path);
//     drive.go(800, 13.9);       // to stand at 800 m, at 50 km/h
//     drive.step(100ms);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/sim/bus/path.hpp"

namespace canvoy::bus {

class BusDrive {
 public:
  static constexpr double acceleration = 1.0;  ///< m/s^2
  static constexpr double deceleration = 1.2;  ///< m/s^2, of service braking

  /// Stands on a path, which must outlive the drive on it.
  void begin(const Path& path, double metres = 0);
  /// Where it shall stand next, in m along the path, and its speed until then in m/s. The place may
  /// be changed while it drives, to one where it can still stop.
  void go(double metres, double metres_per_second);
  void step(Duration time);
  /// In place of a step: at this speed, wherever it should stand, but not off the path.
  void roll(Duration time, double metres_per_second);

  bool is_standing() const { return speed_ <= 0 && rest() <= 0; }
  double speed() const { return speed_; }        ///< m/s
  double metres() const { return metres_; }      ///< along the path
  double odometer() const { return odometer_; }  ///< m since it was made
  /// To where it shall stand.
  double rest() const { return target_ - metres_; }
  /// What it takes to stand.
  double braking_distance() const { return speed_ * speed_ / (2 * deceleration); }
  GeoPoint place() const { return path_ == nullptr ? GeoPoint{} : path_->at(metres_); }
  double heading() const { return path_ == nullptr ? 0 : path_->heading_at(metres_); }

 private:
  const Path* path_ = nullptr;
  double metres_ = 0;
  double odometer_ = 0;
  double speed_ = 0;
  double limit_ = 0;
  double target_ = 0;
};

}  // namespace canvoy::bus
