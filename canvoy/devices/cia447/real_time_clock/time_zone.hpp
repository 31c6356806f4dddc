// Local time: its offset from UTC, and summer time.
//
//     constexpr TimeZone berlin = {.name = "CET", .offset_minutes = 60, .summer = european_summer};
//     const std::int64_t local = utc + ahead_of_utc(berlin, utc);
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia447 {

/// A yearly time, for example the second Sunday of March at 2:00.
struct YearlyMoment {
  std::uint8_t month = 3;             ///< 1 to 12
  std::uint8_t week = 5;              ///< 1 to 4, or 5: the last one
  Weekday weekday = Weekday::sunday;  ///< of the day
  std::uint16_t minute = 60;          ///< of the day
};

/// Summer time of a zone.
struct SummerTime {
  YearlyMoment begin;
  YearlyMoment end;
  bool is_in_utc = true;      ///< otherwise, both are the clock time before the change
  std::int16_t minutes = 60;  ///< by which clocks are ahead then
};

/// Last Sundays of March and October, 1:00 UTC.
inline constexpr SummerTime european_summer = {.begin = {.month = 3}, .end = {.month = 10}};
/// Second Sunday of March, first Sunday of November, at 2:00.
inline constexpr SummerTime american_summer = {.begin = {.month = 3, .week = 2, .minute = 120},
                                               .end = {.month = 11, .week = 1, .minute = 120},
                                               .is_in_utc = false};

struct TimeZone {
  /// For 60F5h, with six characters: a shorter name is filled with spaces there. Must outlive its
  /// users.
  std::string_view name = "UTC";
  std::int16_t offset_minutes = 0;        ///< without summer time; quarters of an hour
  std::optional<SummerTime> summer = {};  ///< nothing: no summer time
};

/// True if it is summer time at a point in time, in seconds since 1970-01-01 UTC.
bool is_summer(const TimeZone& zone, std::int64_t utc);
/// Seconds by which local time is ahead of UTC.
std::int64_t ahead_of_utc(const TimeZone& zone, std::int64_t utc);
/// UTC of a local time. For the hour that occurs twice, `prefers_summer` selects one; an hour that
/// does not occur is taken as without summer time.
std::int64_t utc_of(const TimeZone& zone, std::int64_t local, bool prefers_summer);

}  // namespace canvoy::cia447
