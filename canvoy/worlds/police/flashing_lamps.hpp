// Lamps that flash together, like those of a blue light: an observer sees them flash, although each
// of them is dark half of the time.
//
//     FlashingLamps<2> beacons;
//     beacons.drive(0, true);
//     beacons.step(now);            // each step
//     if (beacons.is_seen(now)) ...
#pragma once

#include <array>
#include <cstddef>

#include "canvoy/can/time.hpp"

namespace canvoy::police {

/// Lamps that flash together: on for a quarter of a second, and off for one.
template <std::size_t count>
class FlashingLamps {
 public:
  static constexpr Duration period = 500ms;  ///< of the flashing: half of it dark

  /// The output of a lamp, from 0; others are ignored.
  void drive(unsigned lamp, bool is_on) {
    if (lamp < count) is_driven_[lamp] = is_on;
  }
  /// Breaks or replaces a lamp.
  void burn_out(unsigned lamp, bool is_burnt = true) { is_burnt_[lamp] = is_burnt; }
  /// The device has no power: all outputs are off.
  void power_off() { is_driven_.fill(false); }
  /// True if any of them gives visible light.
  bool is_lit(Time now) const {
    if ((now - Time{}) % period >= period / 2) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (is_driven_[i] && !is_burnt_[i]) return true;
    }
    return false;
  }
  /// True if this lamp gives light at this instant.
  bool is_lit(Time now, unsigned lamp) const {
    return (now - Time{}) % period < period / 2 && is_driven_[lamp] && !is_burnt_[lamp];
  }
  /// People look: call it in each step.
  void step(Time now) {
    if (is_lit(now)) seen_at_ = now;
  }
  /// True if they flashed a moment ago.
  bool is_seen(Time now) const { return now < seen_at_ + period; }

 private:
  std::array<bool, count> is_driven_{};
  std::array<bool, count> is_burnt_{};
  Time seen_at_{-period};
};

}  // namespace canvoy::police
