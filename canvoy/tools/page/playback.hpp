// Progress of a run relative to the clock: faster or slower, paused, in steps, or at once up to
// some time.
//
//     Playback playback(8h, 10);
//     run_until(playback.wanted(loop.now()));
//     playback.reached(world.now());
#pragma once

#include <algorithm>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

class Playback {
 public:
  static constexpr double speed_max = 1e6;

  /// `speed`: factor to the clock.
  Playback(Duration end, double speed) : end_(Time{} + end), speed_(speed) {}

  /// Time of the run up to which to play now.
  Time wanted(Time clock);
  /// Sets the time reached. A delay is not caught up, except to a time that was sought.
  void reached(Time now);

  void set_speed(double speed) { speed_ = std::clamp(speed, 0.0, speed_max); }
  void set_paused(bool paused) { is_paused_ = paused; }
  /// Plays this duration at once, and pauses.
  void step(Duration further);
  /// Plays up to `when` at once.
  void seek(Time when);
  /// Starts again, and plays up to `when` at once.
  void restart(Time when);

  Time now() const { return now_; }
  /// Present time, or the time that is sought.
  Time aim() const { return std::max(now_, sought_); }
  Time end() const { return end_; }
  double speed() const { return speed_; }
  bool is_paused() const { return is_paused_; }
  /// True while playing to a time that is sought.
  bool is_seeking() const { return now_ < sought_; }
  bool is_over() const { return now_ >= end_; }

 private:
  Time end_;
  double speed_;
  bool is_paused_ = false;
  Time clock_{};
  bool has_clock_ = false;
  Time now_{};
  Time wanted_{};
  Time sought_{};
};

}  // namespace canvoy::tools
