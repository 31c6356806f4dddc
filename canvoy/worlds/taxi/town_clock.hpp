// Time on the clocks of the town, including the night in which they are set.
//
//     const TownClock clock(local_seconds(options.begin), options.zone);
//     clock.local(now)
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia447/real_time_clock/time_zone.hpp"

namespace canvoy::taxi {

class TownClock {
 public:
  /// `local_begin` is their time at time 0, in seconds since 1970-01-01; in the hour that occurs
  /// twice, the first one.
  TownClock(std::int64_t local_begin,  // NOLINT(google-explicit-constructor): without a zone
            const cia447::TimeZone& zone = {})
      : zone_(zone), utc_begin_(cia447::utc_of(zone, local_begin, true)) {}

  /// Whole seconds since 1970-01-01, in UTC.
  std::int64_t utc(Time at) const { return utc_begin_ + (at - Time{}) / 1s; }
  /// Local time, in seconds since 1970-01-01.
  std::int64_t local(Time at) const { return utc(at) + ahead(utc(at)); }
  /// Advance of local time before UTC, in seconds.
  std::int64_t ahead(std::int64_t utc) const { return cia447::ahead_of_utc(zone_, utc); }
  /// Time zone of the town.
  const cia447::TimeZone& zone() const { return zone_; }

 private:
  cia447::TimeZone zone_;
  std::int64_t utc_begin_;
};

}  // namespace canvoy::taxi
