// Local time: how far it is ahead of UTC, and in summer.
//
//     constexpr TimeZone berlin = {.name = "CET", .offset_minutes = 60, .summer = european_summer};
//     const std::int64_t local = utc + ahead_of_utc(berlin, utc);
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia447 {

/// Once a year: the second Sunday of March at 2:00, say.
struct YearlyMoment {
  std::uint8_t month = 3;
  std::uint8_t week = 5;  ///< 1 to 4, or 5: the last one
  Weekday weekday = Weekday::sunday;
  std::uint16_t minute = 60;  ///< of the day
};

struct SummerTime {
  YearlyMoment begin;
  YearlyMoment end;
  bool is_in_utc = true;  ///< else both are what clocks show until then
  std::int16_t minutes = 60;
};

/// Last Sundays of March and October, 1:00 UTC.
inline constexpr SummerTime european_summer = {.begin = {.month = 3}, .end = {.month = 10}};
/// Second Sunday of March, first Sunday of November, at 2:00.
inline constexpr SummerTime american_summer = {.begin = {.month = 3, .week = 2, .minute = 120},
                                               .end = {.month = 11, .week = 1, .minute = 120},
                                               .is_in_utc = false};

struct TimeZone {
  /// For 60F5h; it shall have six characters: what is shorter is filled with spaces there. It must
  /// outlive who uses it.
  std::string_view name = "UTC";
  std::int16_t offset_minutes = 0;  ///< without summer time; quarters of an hour
  std::optional<SummerTime> summer = {};
};

/// Whether it is summer time at a point in time, in seconds since 1970-01-01 UTC.
bool is_summer(const TimeZone& zone, std::int64_t utc);
/// Seconds that clocks are ahead of UTC.
std::int64_t ahead_of_utc(const TimeZone& zone, std::int64_t utc);
/// What clocks show, in UTC. In the hour that there is twice, the one that is meant is that of
/// `prefers_summer`; one that there is not is taken as without summer time.
std::int64_t utc_of(const TimeZone& zone, std::int64_t local, bool prefers_summer);

}  // namespace canvoy::cia447
