// Whether a node that sent heartbeats has stopped: of nodes that are only listened to, the period
// is learned from what is heard.
//
//     HeartbeatWatch watch;
//     watch.hear(time, is_boot_up);
//     if (watch.is_silent(now)) tell();
#pragma once

#include <algorithm>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

class HeartbeatWatch {
 public:
  /// A heartbeat or a boot-up message (CiA 301, 7.2.8.3.2.2 and 7.2.8.3.3). The period follows the
  /// heartbeats, so that a node with a new period is not silent.
  void hear(Duration time, bool is_boot_up) {
    if (heard_at_ != Duration{} && !is_boot_up) {
      const Duration passed = time - heard_at_;
      period_ = std::max(passed, period_ - period_ / 8);
    }
    heard_at_ = time;
    has_heartbeat_ = has_heartbeat_ || !is_boot_up;
  }

  /// True after three periods without a heartbeat, at least one second; after ten seconds if only
  /// one was heard. False for a node that has only booted up.
  bool is_silent(Duration now) const {
    constexpr int periods_until_silent = 3;
    constexpr Duration silent_after_min = 1s;
    constexpr Duration silent_after_one = 10s;
    const Duration patience = period_ == Duration{}
                                  ? silent_after_one
                                  : std::max(periods_until_silent * period_, silent_after_min);
    return has_heartbeat_ && now - heard_at_ > patience;
  }

  /// Time of the last heartbeat or boot-up message.
  Duration heard_at() const { return heard_at_; }

 private:
  Duration heard_at_{};
  Duration period_{};  ///< longest recent interval; 0: at most one heartbeat
  bool has_heartbeat_ = false;
};

}  // namespace canvoy::tools
