// Movement of the car from one state to another within limits of velocity, acceleration and jerk:
// the curve of CiA 417-4, figure 1, with the ramps of CiA 402, 6086h.
//
// A profile is computed once, when the target is set, and then evaluated in closed form for any
// time, without steps or accumulated errors. It works in any unit, such as metres, millimetres or
// counts, and in seconds.
//
//     MotionProfile trip = MotionProfile::to_position({}, 12.5, limits);
//     trip.at(3.2).velocity;  // 3.2 s after the start
//     trip = MotionProfile::to_velocity(trip.at(3.2), 0, limits);  // and now to a stop
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "canvoy/profiles/cia402/values.hpp"

namespace canvoy::cia417 {

/// State at one moment; units are those of the caller, and seconds.
struct MotionState {
  double position = 0;      ///< upwards
  double velocity = 0;      ///< units per second
  double acceleration = 0;  ///< units per second squared

  friend constexpr bool operator==(const MotionState&, const MotionState&) = default;
};

/// All of them positive.
struct MotionLimits {
  /// Limits of the four bends of the velocity, A to D of figure 1; 0: not limited, the acceleration
  /// jumps. E and F are C and D of a separate profile, from the end velocity to a stop.
  struct Jerks {
    double start_acceleration = 0;  ///< A
    double end_acceleration = 0;    ///< B
    double start_deceleration = 0;  ///< C
    double end_deceleration = 0;    ///< D
  };

  double velocity = 1;      ///< the greatest, in either direction
  double acceleration = 1;  ///< the greatest, gaining speed
  double deceleration = 1;  ///< the greatest, losing speed
  Jerks jerk = {};          ///< 0: the acceleration jumps
  /// Linear ramps have no jerk. The other two are ramps of one piece, from acceleration 0 to
  /// acceleration 0; a profile that starts with an acceleration is jerk-limited.
  cia402::ProfileType type = cia402::ProfileType::jerk_limited;
};

class MotionProfile {
 public:
  /// At rest at 0.
  MotionProfile() = default;
  /// A profile that stays at a position.
  static MotionProfile resting_at(double position);

  /// Moves to `target` with `end_velocity`, or less if the distance is too short to reach it. If
  /// that is not possible, the car stops behind the target and comes back: see can_reach(). The
  /// cost is limited: about forty trials of the velocity on the way.
  static MotionProfile to_position(const MotionState& from, double target,
                                   const MotionLimits& limits, double velocity_there = 0);
  /// Changes to `velocity`, positive or negative, and keeps it.
  static MotionProfile to_velocity(const MotionState& from, double velocity,
                                   const MotionLimits& limits);
  /// True if to_position() moves to `target` without turning round.
  static bool can_reach(const MotionState& from, double target, const MotionLimits& limits,
                        double velocity_there = 0);
  /// Distance from `from` to a stop, negative downwards.
  static double stopping_distance(const MotionState& from, const MotionLimits& limits);

  /// Evaluated in closed form, at a cost linear in the number of pieces. After the end, it
  /// continues with the end velocity.
  MotionState at(double seconds) const;
  /// Seconds from the start to the end.
  double duration() const { return duration_; }
  /// Exactly equal to the target.
  const MotionState& end() const { return end_; }
  /// The highest velocity on the way, in its direction.
  double peak_velocity() const;

 private:
  struct Way;
  class Ramp;

  /// Curve of the velocity within a piece.
  enum class Shape : std::uint8_t { polynomial, sine_squared, jerk_free };
  struct Piece {
    double duration = 0;
    double jerk = 0;  ///< for the other shapes, the change of the velocity
    MotionState start;
    Shape shape = Shape::polynomial;
  };
  /// A ramp to a stop, and from there a ramp up, a stretch and a ramp down. Each ramp may start
  /// with an acceleration that is reduced first.
  static constexpr std::size_t pieces_max = 4 + 4 + 1 + 4;

  static MotionState evaluate(const Piece& piece, double seconds);
  void append(const Ramp& ramp);
  void cruise(double seconds);
  void travel(const Way& way);

  std::array<Piece, pieces_max> pieces_{};
  std::size_t piece_count_ = 0;
  double duration_ = 0;
  MotionState end_;
};

}  // namespace canvoy::cia417
