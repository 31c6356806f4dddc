// Limits the influence of a clock on a taximeter: in a trip, it may differ by at most two minutes
// from the meter's own time. Between two trips it may be set, and the difference is recorded. So
// neither a clock that jumps nor one that drifts changes a trip or its tariff.
//
//     ClockBounds bounds;
//     const LocalTime now = bounds.take(told, node.now(), has_trip);
//     if (bounds.is_beyond(told, node.now())) ...
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"

namespace canvoy::cia447 {

class ClockBounds {
 public:
  static constexpr std::int64_t step_max = 120;          ///< s
  static constexpr std::int32_t offset_step_max = 3600;  ///< s: start or end of summer time

  /// The time to use. The first one is accepted.
  LocalTime take(const LocalTime& told, Time now, bool has_trip) {
    if (!known_) known_ = Known{told, now};
    return has_trip && is_beyond(told, now) ? expected(now) : told;
  }
  /// True if a clock is beyond its limit: take() does not use it in a trip.
  bool is_beyond(const LocalTime& told, Time now) const {
    if (!known_) return false;
    const std::int64_t step = told.utc() - expected(now).utc();
    const std::int32_t offset_step = told.utc_offset - known_->time.utc_offset;
    return step > step_max || step < -step_max || offset_step > offset_step_max ||
           offset_step < -offset_step_max;
  }
  /// Seconds by which it is beyond, in local time.
  std::int64_t step(const LocalTime& told, Time now) const {
    return known_ ? told.seconds - expected(now).seconds : 0;
  }
  /// Accepts this as the time.
  void settle(const LocalTime& told, Time now) { known_ = Known{told, now}; }

 private:
  struct Known {
    LocalTime time;
    Time at{};
  };
  LocalTime expected(Time now) const {
    LocalTime time = known_->time;
    time.seconds += std::chrono::floor<std::chrono::seconds>(now - known_->at).count();
    return time;
  }

  std::optional<Known> known_;
};

}  // namespace canvoy::cia447
