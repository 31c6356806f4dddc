// The motion of a bus: it drives along a path to its next halt, as fast as allowed, and with no
// harder acceleration than passengers can stand.
//
//     BusDrive drive;
//     drive.begin(path);
//     drive.go(800, 13.9);       // to stand at 800 m, at 50 km/h
//     drive.step(100ms);
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/bus_line/path.hpp"

namespace canvoy::bus_line {

class BusDrive {
 public:
  static constexpr double acceleration = 1.0;  ///< m/s^2
  static constexpr double deceleration = 1.2;  ///< m/s^2, of service braking

  /// Stands on a path, which must outlive the drive on it.
  void begin(const Path& path, double metres = 0);
  /// Sets the next halt, in m along the path, and the speed until then in m/s. The halt may be
  /// changed while the bus drives, to one before which it can still stop.
  void go(double metres, double metres_per_second);
  /// Drives on for this time, towards the halt.
  void step(Duration time);
  /// Replaces a step: rolls at this speed whatever the next halt, but not off the path.
  void roll(Duration time, double metres_per_second);

  /// True if it has come to the halt.
  bool is_standing() const { return speed_ <= 0 && rest() <= 0; }
  double speed() const { return speed_; }        ///< m/s
  double metres() const { return metres_; }      ///< along the path
  double odometer() const { return odometer_; }  ///< m since construction
  /// Distance to the next halt, in m.
  double rest() const { return target_ - metres_; }
  /// Distance that the bus needs to stop, in m.
  double braking_distance() const { return speed_ * speed_ / (2 * deceleration); }
  /// Where it is on the earth.
  GeoPoint place() const { return path_ == nullptr ? GeoPoint{} : path_->at(metres_); }
  /// Direction of the path there: degrees clockwise from north; 0 without a path.
  double heading() const { return path_ == nullptr ? 0 : path_->heading_at(metres_); }

 private:
  const Path* path_ = nullptr;
  double metres_ = 0;
  double odometer_ = 0;
  double speed_ = 0;
  double limit_ = 0;
  double target_ = 0;
};

}  // namespace canvoy::bus_line
