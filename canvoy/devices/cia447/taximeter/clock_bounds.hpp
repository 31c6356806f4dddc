// Bounds what a clock can do to a taximeter: in a trip it may not be more than two minutes away
// from where the meter's own time has carried it; between two trips it may be set, and who keeps
// the record is told. So neither a clock that steps nor one that drifts moves a trip or its tariff.
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
  static constexpr std::int32_t offset_step_max = 3600;  ///< s: summer time begins or ends

  /// The time to go by. The first one is believed.
  LocalTime take(const LocalTime& told, Time now, bool has_trip) {
    if (!known_) known_ = Known{told, now};
    return has_trip && is_beyond(told, now) ? expected(now) : told;
  }
  /// More than a clock may go away; then take() does not go by it in a trip.
  bool is_beyond(const LocalTime& told, Time now) const {
    if (!known_) return false;
    const std::int64_t step = told.utc() - expected(now).utc();
    const std::int32_t offset_step = told.utc_offset - known_->time.utc_offset;
    return step > step_max || step < -step_max || offset_step > offset_step_max ||
           offset_step < -offset_step_max;
  }
  /// Seconds by which it is beyond: of people's time.
  std::int64_t step(const LocalTime& told, Time now) const {
    return known_ ? told.seconds - expected(now).seconds : 0;
  }
  /// From here on that is the time.
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
