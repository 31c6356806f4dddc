// The clock of an on-board computer: local time by satellites, as time fixing reports it, and
// between two messages by its own oscillator; while that is silent, a clock of its own that may be
// wrong.
//
//     LineClock clock(hardware.clock);
//     clock.begin(now);
//     if (clock.hear(local, now)) ...     // what was told last is not so any more
//     clock.local(now)
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"

namespace canvoy::bus_line {

class LineClock {
 public:
  /// Local time of a clock that may be wrong; empty: it has none.
  using OwnClock = Callback<std::optional<cia407::CivilTime>()>;

  /// `own` returns local time; empty: the device has no clock of its own.
  explicit LineClock(const OwnClock& own) : own_(own) {}

  /// Call it when the computer boots.
  void begin(Time now) { booted_ = now; }
  /// Call it when messages of other devices may be lost.
  void forget() {
    heard_.reset();
    was_known_ = false;
  }
  /// Takes local time, in s since 1970. True: the clock jumps, as where summer time begins or ends.
  bool hear(std::int64_t local, Time now);
  /// Empty: the time is unknown.
  std::optional<cia407::CivilTime> local(Time now) const;
  /// True if the time has become known or unknown since the last call.
  bool has_come_or_gone(Time now) {
    const bool is_known = local(now).has_value();
    return std::exchange(was_known_, is_known) != is_known;
  }

 private:
  OwnClock own_;
  std::optional<std::int64_t> heard_;  ///< local, s since 1970, at base_
  Time base_{};
  Time heard_at_{};  ///< time of the last message
  Time booted_{};
  bool was_known_ = false;
};

}  // namespace canvoy::bus_line
