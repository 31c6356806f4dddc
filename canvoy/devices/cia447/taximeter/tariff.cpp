#include "canvoy/devices/cia447/taximeter/tariff.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

bool is_holiday(const Tariff& tariff, std::int64_t days) {
  const CivilTime date = civil_time(days * seconds_a_day);
  return std::ranges::any_of(tariff.holidays, [&date](const Holiday& holiday) {
    return (holiday.year == 0 || holiday.year == date.year) && holiday.month == date.month &&
           holiday.day == date.day;
  });
}

/// The bit of TariffHours::days.
unsigned kind_of_day(const Tariff& tariff, std::int64_t days) {
  if (is_holiday(tariff, days)) return on_holidays;
  return 1U << static_cast<unsigned>(weekday_of(days));
}

struct Moment {
  unsigned minute;     ///< of the day
  unsigned today;      ///< kind_of_day()
  unsigned yesterday;  ///< of hours that began before midnight
};

bool holds(const TariffHours& hours, const Moment& moment) {
  const bool is_of_today = (hours.days & moment.today) != 0;
  const bool is_of_yesterday = (hours.days & moment.yesterday) != 0;
  if (hours.from < hours.to) {
    return is_of_today && moment.minute >= hours.from && moment.minute < hours.to;
  }
  return (is_of_today && moment.minute >= hours.from) ||
         (is_of_yesterday && moment.minute < hours.to);
}

}  // namespace

unsigned level_at(const Tariff& tariff, std::int64_t local_seconds) {
  const std::int64_t days = civil::floored(local_seconds, seconds_a_day);
  const std::int64_t of_day = local_seconds - days * seconds_a_day;
  const Moment moment = {.minute = static_cast<unsigned>(of_day / seconds_a_minute),
                         .today = kind_of_day(tariff, days),
                         .yesterday = kind_of_day(tariff, days - 1)};
  for (const TariffHours& hours : tariff.hours) {
    if (hours.level < tariff.levels.size() && holds(hours, moment)) return hours.level;
  }
  return 0;
}

}  // namespace canvoy::cia447
