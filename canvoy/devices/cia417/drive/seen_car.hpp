// The car as other devices report it: its velocity from its drive (6433h), its position from its
// position unit (6383h), and whether the two agree.
//
//     SeenCar car(node.dictionary(), 1, {.drive_micrometre = 1000});
//     car.nearest_stop(ramps)
//     if (car.is_encoder_dead(500ms, now)) ...   // it moves, and its position does not change
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/devices/cia417/lift/lift_bound.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"

namespace canvoy::cia417 {

/// Positions, velocities and their changes are in units of the drive.
class SeenCar {
 public:
  /// Units of the two devices.
  struct Units {
    std::int32_t drive_micrometre = 1000;    ///< of 6433h
    std::int32_t position_micrometre = 100;  ///< one count of 6383h
  };
  /// `dictionary` must outlive this; `lift` is 1 to 8.
  SeenCar(Dictionary& dictionary, unsigned lift, const Units& units)
      : velocity_(dictionary, lift), position_(dictionary, lift), units_(units) {}

  /// Velocity that the drive reported last.
  double velocity() const { return velocity_.raw(); }
  /// Position that the position unit reported last, in units of the drive.
  double position() const;
  /// True if it is faster than the jitter of an encoder.
  bool moves() const;
  /// The worst case of the control loop: while the car gains speed, with all of its acceleration.
  /// Therefore a stop is never planned too near.
  MotionState state(const MotionLimits& ramps) const;
  /// Position of the standstill of a car that already slows down with all of its deceleration.
  double nearest_stop(const MotionLimits& ramps) const;

  /// Discards the velocity.
  void forget_velocity() { velocity_ = 0; }
  /// Call it when the drive has sent the velocity.
  void velocity_came();

  /// Starts to monitor whether its position changes while it moves.
  void watch_anew(Time now);
  /// True if its position has changed since watch_anew().
  bool has_moved() const;
  /// True if it has not changed for `time`: a dead encoder always sends the same position.
  bool is_encoder_dead(Duration time, Time now) const {
    return !has_moved() && now - watched_since_ >= time;
  }

 private:
  LiftBound<velocity_actual_value> velocity_;
  LiftBound<position_value> position_;
  Units units_;
  double last_velocity_ = 0;
  double acceleration_ = 0;
  double watched_position_ = 0;
  Time watched_since_{};
};

/// Jitter of an encoder, in units of the drive.
inline constexpr double moving_distance = 5;

}  // namespace canvoy::cia417
