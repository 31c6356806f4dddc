// Local time where a line runs, with summer time: plain data, so that a simulation needs no
// database of time zones.
//
//     const LocalClock clock({OffsetChange{.offset = 3600}});
//     clock.local(clock.service_begin(date) + 8 * 3600);
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace canvoy::bus_line {

/// Seconds since 1970-01-01 00:00, of UTC or of a local clock.
using EpochSeconds = std::int64_t;

/// Local time is UTC plus `offset` seconds, from `since` (UTC) on.
struct OffsetChange {
  EpochSeconds since = 0;   ///< UTC, seconds since 1970-01-01
  std::int64_t offset = 0;  ///< seconds east of UTC
  friend bool operator==(const OffsetChange&, const OffsetChange&) = default;
};

class LocalClock {
 public:
  /// At least one change, in the order of their times. The first holds also before its time.
  explicit LocalClock(std::vector<OffsetChange> changes);

  /// Seconds east of UTC at that time; before the first change: its offset.
  std::int64_t offset_at(EpochSeconds utc) const;
  /// Local time in seconds since 1970-01-01, local midnight.
  EpochSeconds local(EpochSeconds utc) const { return utc + offset_at(utc); }
  /// Start from which the times of a timetable (GTFS) count, in UTC: twelve hours before noon,
  /// which is midnight unless the clocks are set on this day.
  EpochSeconds service_begin(const std::chrono::year_month_day& date) const;

 private:
  std::vector<OffsetChange> changes_;
};

}  // namespace canvoy::bus_line
