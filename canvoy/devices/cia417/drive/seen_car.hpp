// The car as others tell of it: its velocity by its drive (6433h), its position by its position
// unit (6383h), and whether the two agree.
//
//     SeenCar car(node.dictionary(), 1, {.drive_micrometre = 1000});
//     car.nearest_stop(ramps)
//     if (car.is_encoder_dead(500ms, now)) ...   // it moves, and its position does not change
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/controller/lift_bound.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"

namespace canvoy::cia417 {

/// Positions, velocities and their changes are in units of the drive.
class SeenCar {
 public:
  struct Units {
    std::int32_t drive_micrometre = 1000;    ///< of 6433h
    std::int32_t position_micrometre = 100;  ///< one count of 6383h
  };
  /// `dictionary` must outlive this; `lift` is 1 to 8.
  SeenCar(Dictionary& dictionary, unsigned lift, const Units& units)
      : velocity_(dictionary, lift), position_(dictionary, lift), units_(units) {}

  double velocity() const { return velocity_.raw(); }
  double position() const;
  /// Faster than an encoder jitters.
  bool moves() const;
  /// What the control loop may do: while it gains speed, with all of its acceleration. So a stop is
  /// never planned too near.
  MotionState state(const MotionLimits& ramps) const;
  /// Where a car stands still that slows down with all of its deceleration already.
  double nearest_stop(const MotionLimits& ramps) const;

  /// It is not known any more how fast it is.
  void forget_velocity() { velocity_ = 0; }
  /// The drive has told the velocity again.
  void velocity_came();

  /// From here on its position has to change, while it moves.
  void watch_anew(Time now);
  bool has_moved() const;
  /// It has not for `time`: a dead encoder tells the same position for ever.
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

/// What an encoder jitters, in units of the drive.
inline constexpr double moving_distance = 5;

}  // namespace canvoy::cia417
