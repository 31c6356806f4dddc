// Time for which the doors of a stop stay open, and when they close by nudging: a time to get in
// and out, which passengers who hold the doors prolong up to a limit.
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
  /// Forgets the stop.
  void begin_anew() { *this = {}; }
  /// Starts a stop.
  void begin(Duration dwell) {
    dwell_ = dwell;
    closed();
  }
  /// Closing doors open again.
  void open_again(Duration dwell) { dwell_ = dwell; }
  /// Notes that the doors are open: the longest time begins here.
  void opened(Time now) {
    if (tries_ == 0) opened_at_ = now;
    is_held_ = false;
    until_ = now + dwell_;
  }
  /// Keeps the doors open until then at least.
  void prolong(Time until) { until_ = std::max(until_, until); }
  void end(Time now) { until_ = std::min(until_, now); }
  /// Notes that the doors are closed: the stop has ended.
  void closed() {
    tries_ = 0;
    is_nudging_ = false;
  }
  /// Counts that they did not close in time. True from the third time on.
  bool was_late() { return ++tries_ >= 3; }

  /// Doors that have to stay open: nothing counts as an obstacle, and the time to nudging starts at
  /// the end of that.
  bool hold(bool is_held, Time now) {
    if (std::exchange(is_held_, is_held) && !is_held) opened_at_ = now;
    return is_held;
  }
  /// True if they have to close. After `nudging` they close even with an obstacle, and a button
  /// that is still held may be stuck: it is ignored.
  bool ends(Time now, Duration nudging, bool is_button_held) {
    is_nudging_ = now >= nudges_at(nudging);
    if (is_nudging_) ignores_button_ = is_button_held;
    return is_nudging_ || now >= until_;
  }
  /// Time of the next check.
  Time next(Duration nudging) const { return std::min(until_, nudges_at(nudging)); }
  /// True if the doors close by nudging at this stop.
  bool is_nudging() const { return is_nudging_; }
  /// True if the button for door open is held, and not for too long.
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
