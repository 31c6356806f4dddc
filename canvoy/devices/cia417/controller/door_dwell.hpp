// How long the doors of a stop stay open, and when they close by nudging: a time to get in and out,
// longer by who holds them, and an end to that.
//
//     DoorDwell dwell;
//     dwell.begin(3s);
//     dwell.opened(now);
//     dwell.prolong(now + 2s);                    // somebody stands in the door
//     if (!dwell.hold(load.overload, now) && dwell.ends(now, 20s, is_button_held)) close();
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "canvoy/can/time.hpp"

namespace canvoy::cia417 {

class DoorDwell {
 public:
  void begin_anew() { *this = {}; }
  /// A stop.
  void begin(Duration dwell) {
    dwell_ = dwell;
    closed();
  }
  /// Doors open again that were closing.
  void open_again(Duration dwell) { dwell_ = dwell; }
  void opened(Time now) {
    if (tries_ == 0) opened_at_ = now;
    is_held_ = false;
    until_ = now + dwell_;
  }
  void prolong(Time until) { until_ = std::max(until_, until); }
  void end(Time now) { until_ = std::min(until_, now); }
  void closed() {
    tries_ = 0;
    is_nudging_ = false;
  }
  /// They did not close in time. True: not for the first time, nor the second.
  bool was_late() { return ++tries_ >= 3; }

  /// Doors that have to stay open: nobody is in their way, and nudging counts from the end of that.
  bool hold(bool is_held, Time now) {
    if (std::exchange(is_held_, is_held) && !is_held) opened_at_ = now;
    return is_held;
  }
  /// They are to close. After `nudging` they do whatever stands in them, and a button that is held
  /// then may be stuck: it counts no longer.
  bool ends(Time now, Duration nudging, bool is_button_held) {
    is_nudging_ = now >= nudges_at(nudging);
    if (is_nudging_) ignores_button_ = is_button_held;
    return is_nudging_ || now >= until_;
  }
  /// When that is to be asked again.
  Time next(Duration nudging) const { return std::min(until_, nudges_at(nudging)); }
  bool is_nudging() const { return is_nudging_; }
  /// The button for door open is held, and has not been for too long.
  bool obeys_button(bool is_held) {
    if (!is_held) ignores_button_ = false;
    return is_held && !ignores_button_;
  }

 private:
  Time nudges_at(Duration nudging) const { return opened_at_ + std::max(nudging, dwell_); }

  Duration dwell_{};
  Time until_{};
  Time opened_at_{};
  std::uint8_t tries_ = 0;  ///< of closing
  bool is_held_ = false;
  bool is_nudging_ = false;
  bool ignores_button_ = false;
};

}  // namespace canvoy::cia417
