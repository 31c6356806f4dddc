// How far a run is to be played, by the clock: faster or slower than it, paused, in steps, or at
// once up to some time.
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

  /// `speed`: times faster than the clock.
  Playback(Duration end, double speed) : end_(Time{} + end), speed_(speed) {}

  /// Up to which time of the run to play now.
  Time wanted(Time clock);
  /// How far it has come. What could not be played in time is not caught up with, but where it was
  /// sought.
  void reached(Time now);

  void set_speed(double speed) { speed_ = std::clamp(speed, 0.0, speed_max); }
  void set_paused(bool paused) { is_paused_ = paused; }
  /// Plays so much further at once, and pauses.
  void step(Duration further);
  /// Plays up to `when` at once.
  void seek(Time when);
  /// From the start once more, at once up to `when`.
  void restart(Time when);

  Time now() const { return now_; }
  Time end() const { return end_; }
  double speed() const { return speed_; }
  bool is_paused() const { return is_paused_; }
  /// It is on the way to where it was sent.
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
