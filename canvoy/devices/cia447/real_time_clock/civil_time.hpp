// Dates and times of day, and their conversion to seconds since 1970-01-01: for clocks of CiA 447-3
// (60F0h to 60F3h), with years up to 65533.
//
//     const CivilTime time = civil_time(1'230'768'000);  // 2009-01-01 00:00:00
//     seconds_since_1970({.year = 2009, .month = 1, .day = 1});
#pragma once

#include <cstdint>

namespace canvoy::cia447 {

struct CivilTime {
  std::int64_t year = 1970;  ///< with its century
  unsigned month = 1;        ///< 1 to 12
  unsigned day = 1;          ///< 1 to 31
  unsigned hour = 0;         ///< 0 to 23
  unsigned minute = 0;       ///< 0 to 59
  unsigned second = 0;       ///< 0 to 59

  friend constexpr bool operator==(const CivilTime&, const CivilTime&) = default;
};

/// Days of a week.
enum class Weekday : std::uint8_t {
  monday,
  tuesday,
  wednesday,
  thursday,
  friday,
  saturday,
  sunday
};

inline constexpr std::int64_t seconds_a_minute = 60;   ///< seconds
inline constexpr std::int64_t seconds_an_hour = 3600;  ///< seconds
inline constexpr std::int64_t seconds_a_day = 86'400;  ///< seconds, without leap seconds

namespace civil {

/// Rounds down, also below 0.
constexpr std::int64_t floored(std::int64_t number, std::int64_t divisor) {
  return (number - ((number % divisor + divisor) % divisor)) / divisor;
}
/// Remainder from 0 to `divisor` - 1, also of a negative number.
constexpr std::int64_t remainder(std::int64_t number, std::int64_t divisor) {
  return (number % divisor + divisor) % divisor;
}

}  // namespace civil

/// True for a leap year of the Gregorian calendar.
constexpr bool is_leap_year(std::int64_t year) {
  return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}
/// 0 if there is no such month.
constexpr unsigned days_of_month(std::int64_t year, unsigned month) {
  constexpr std::uint8_t days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (month < 1 || month > 12) return 0;
  return days[month - 1] + (month == 2 && is_leap_year(year) ? 1U : 0U);
}

/// Days since 1970-01-01, in the Gregorian calendar. Years begin in March here, so that the leap
/// day comes last, and every four hundred years have the same length.
constexpr std::int64_t days_since_1970(std::int64_t year, unsigned month, unsigned day) {
  const std::int64_t shifted = month <= 2 ? year - 1 : year;
  const std::int64_t era = civil::floored(shifted, 400);
  const std::int64_t year_of_era = shifted - era * 400;
  const std::int64_t month_of_year = (month + 9) % 12;  // 0: March
  const std::int64_t day_of_year = (153 * month_of_year + 2) / 5 + day - 1;
  const std::int64_t day_of_era =
      year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
  constexpr std::int64_t days_an_era = 146'097;
  constexpr std::int64_t to_1970 = 719'468;
  return era * days_an_era + day_of_era - to_1970;
}
/// Weekday of a number of days since 1970-01-01.
constexpr Weekday weekday_of(std::int64_t days) {
  return static_cast<Weekday>(civil::remainder(days + 3, 7));  // 1970-01-01: a Thursday
}

/// Seconds since 1970-01-01; negative before it.
constexpr std::int64_t seconds_since_1970(const CivilTime& time) {
  return days_since_1970(time.year, time.month, time.day) * seconds_a_day +
         time.hour * seconds_an_hour + time.minute * seconds_a_minute + time.second;
}
/// Date and time of a number of seconds since 1970-01-01.
constexpr CivilTime civil_time(std::int64_t since_1970) {
  const std::int64_t days = civil::floored(since_1970, seconds_a_day);
  const std::int64_t of_day = since_1970 - days * seconds_a_day;
  const std::int64_t shifted = days + 719'468;
  const std::int64_t era = civil::floored(shifted, 146'097);
  const std::int64_t day_of_era = shifted - era * 146'097;
  const std::int64_t year_of_era =
      (day_of_era - day_of_era / 1460 + day_of_era / 36'524 - day_of_era / 146'096) / 365;
  const std::int64_t day_of_year =
      day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const std::int64_t month_of_year = (5 * day_of_year + 2) / 153;
  const std::int64_t month = month_of_year < 10 ? month_of_year + 3 : month_of_year - 9;
  return {.year = year_of_era + era * 400 + (month <= 2 ? 1 : 0),
          .month = static_cast<unsigned>(month),
          .day = static_cast<unsigned>(day_of_year - (153 * month_of_year + 2) / 5 + 1),
          .hour = static_cast<unsigned>(of_day / seconds_an_hour),
          .minute = static_cast<unsigned>(of_day / seconds_a_minute % 60),
          .second = static_cast<unsigned>(of_day % 60)};
}

}  // namespace canvoy::cia447
