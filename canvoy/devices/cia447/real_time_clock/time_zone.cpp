#include "canvoy/devices/cia447/real_time_clock/time_zone.hpp"

namespace canvoy::cia447 {

namespace {

/// In seconds since 1970-01-01, of the clock in which the moment is given.
std::int64_t moment_of(const YearlyMoment& moment, std::int64_t year) {
  const unsigned last_day = days_of_month(year, moment.month);
  const bool is_last = moment.week >= 5;
  const unsigned first_possible = is_last ? last_day - 6 : (moment.week - 1U) * 7 + 1;
  const std::int64_t days = days_since_1970(year, moment.month, first_possible);
  const auto wanted = static_cast<std::int64_t>(moment.weekday);
  const auto found = static_cast<std::int64_t>(weekday_of(days));
  return (days + civil::remainder(wanted - found, 7)) * seconds_a_day +
         moment.minute * seconds_a_minute;
}

std::int64_t standard_offset(const TimeZone& zone) {
  return zone.offset_minutes * seconds_a_minute;
}

}  // namespace

bool is_summer(const TimeZone& zone, std::int64_t utc) {
  if (!zone.summer) return false;
  const SummerTime& summer = *zone.summer;
  const std::int64_t offset = standard_offset(zone);
  const std::int64_t year = civil_time(utc + offset).year;
  const std::int64_t to_begin = summer.is_in_utc ? 0 : offset;
  const std::int64_t to_end = summer.is_in_utc ? 0 : offset + summer.minutes * seconds_a_minute;
  const std::int64_t begin = moment_of(summer.begin, year) - to_begin;
  const std::int64_t end = moment_of(summer.end, year) - to_end;
  // South of the equator it lasts over the turn of the year.
  return begin < end ? utc >= begin && utc < end : utc >= begin || utc < end;
}

std::int64_t ahead_of_utc(const TimeZone& zone, std::int64_t utc) {
  const bool is_ahead = zone.summer && is_summer(zone, utc);
  const std::int64_t more = is_ahead ? zone.summer->minutes * seconds_a_minute : 0;
  return standard_offset(zone) + more;
}

std::int64_t utc_of(const TimeZone& zone, std::int64_t local, bool prefers_summer) {
  const std::int64_t as_standard = local - standard_offset(zone);
  if (!zone.summer) return as_standard;
  const std::int64_t as_summer = as_standard - zone.summer->minutes * seconds_a_minute;
  const bool can_be_summer = is_summer(zone, as_summer);
  const bool can_be_standard = !is_summer(zone, as_standard);
  return can_be_summer && (prefers_summer || !can_be_standard) ? as_summer : as_standard;
}

}  // namespace canvoy::cia447
