// How a door panel moves: evenly speeding up, at constant speed, and evenly slowing down, from any
// position and speed on. Closed form: asked for any time, stepped by nobody.
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
  struct Way {
    double target_m = 0;
    double speed_m_s = 0.5;          ///< at most, above 0
    double acceleration_m_s2 = 1.0;  ///< and deceleration, above 0
  };

  /// At rest at `position_m`.
  void rest(Time now, double position_m);
  /// From where it is and as fast as it is to the target, where it rests. What is too fast to stop
  /// there, as at an end of its way, is stopped harder.
  void go(Time now, const Way& way);
  /// Slows down and rests.
  void stop(Time now, double deceleration_m_s2);

  double position_m(Time at) const;
  double speed_m_s(Time at) const;  ///< opening is positive
  /// Since when it rests, or will.
  Time end() const { return start_of(count_); }
  /// The first time after `after` at which it is at or beyond `position_m`, in the direction that
  /// it has; never where it does not come there.
  Time time_at(double position_m, Time after) const;

 private:
  /// A part of the way with constant acceleration.
  struct Part {
    double seconds = 0;  ///< from the start of the motion on
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
  std::size_t count_ = 0;  ///< before the rest
};

}  // namespace canvoy::lift
