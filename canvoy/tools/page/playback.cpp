#include "canvoy/tools/page/playback.hpp"

namespace canvoy::tools {

namespace {

/// Maximum delay of the computer before the run waits for it, by the clock.
constexpr Duration late_most = 200ms;

Duration times(Duration duration, double factor) {
  return Duration(static_cast<Duration::rep>(static_cast<double>(duration.count()) * factor));
}

}  // namespace

Time Playback::wanted(Time clock) {
  const Duration passed = has_clock_ ? clock - clock_ : Duration::zero();
  clock_ = clock;
  has_clock_ = true;
  if (is_seeking()) return wanted_ = sought_;
  if (!is_paused_) wanted_ += times(passed, speed_);
  return wanted_ = std::min(wanted_, end_);
}

void Playback::reached(Time now) {
  now_ = now;
  if (!is_seeking()) wanted_ = std::min(wanted_, now_ + times(late_most, speed_));
}

void Playback::step(Duration further) {
  is_paused_ = true;
  seek(std::max(now_, sought_) + further);
}

void Playback::seek(Time when) {
  sought_ = std::min(when, end_);
  wanted_ = std::max(now_, sought_);
}

void Playback::restart(Time when) {
  now_ = wanted_ = Time{};
  sought_ = std::min(when, end_);
}

}  // namespace canvoy::tools
