// Motion of a door panel: constant acceleration, constant speed, and constant deceleration, from
// any position and speed. It is a closed form, computed for any time, without steps.
//
//     DoorMotion motion;
//     motion.go(now, {.target_m = 0.9, .speed_m_s = 0.5, .acceleration_m_s2 = 1.2});
//     motion.position_m(now + 1s);
//     motion.time_at(0.4);   // when it comes by there
#pragma once

#include <array>
#include <cstddef>

#include "canvoy/can/time.hpp"

namespace canvoy::lift {

class DoorMotion {
 public:
  /// A way to go.
  struct Way {
    double target_m = 0;             ///< end position, from closed
    double speed_m_s = 0.5;          ///< at most, above 0
    double acceleration_m_s2 = 1.0;  ///< and deceleration, above 0
  };

  /// Rests at `position_m`.
  void rest(Time now, double position_m);
  /// Moves from its present position and speed to the target, where it rests. If it is too fast to
  /// stop there, as at an end of its travel, it decelerates harder.
  void go(Time now, const Way& way);
  /// Decelerates to rest.
  void stop(Time now, double deceleration_m_s2);

  /// From closed; at any time from the beginning on.
  double position_m(Time at) const;
  double speed_m_s(Time at) const;  ///< opening is positive
  /// Time from which it rests.
  Time end() const { return start_of(count_); }
  /// The first time after `after` at which it is at or beyond `position_m`, in its present
  /// direction; never where it does not reach it.
  Time time_at(double position_m, Time after) const;

 private:
  /// A part of the way with constant acceleration.
  struct Part {
    double seconds = 0;  ///< from the start of the motion
    double position_m = 0;
    double speed_m_s = 0;
    double acceleration_m_s2 = 0;
  };
  /// Turning, speeding up, constant speed, slowing down, rest.
  static constexpr std::size_t parts_max = 5;

  void begin(Time now);
  void add(double duration_s, double acceleration_m_s2);
  const Part& part_at(double seconds) const;
  Time start_of(std::size_t part) const;
  double seconds_of(Time at) const;

  Time start_{};
  std::array<Part, parts_max> parts_{};
  std::size_t count_ = 0;  ///< parts before the rest
};

}  // namespace canvoy::lift
