// Time and date in the coding of the objects of CiA 407 (610Eh, 6115h, 6523h, 6680h), and as
// CivilTime.
//
//     set_local_time(computer, CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8});
//     std::optional<CivilTime> now = local_time(values);
//
// Days have quarters in these objects. Here they are whole: the 23rd is the number 23, and each
// quarter of it (22.25 to 23) is read as the 23rd, as in SAE J1939 (errata 56).
#pragma once

#include <cmath>
#include <optional>

#include "canvoy/devices/cia407/kit/virtual_devices.hpp"
#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia407 {

using cia447::CivilTime;

/// Code 0 of the objects with a year.
inline constexpr std::int64_t first_year = 1985;
inline constexpr std::int64_t last_year = 2235;  ///< code 250

/// True if the objects can hold the time.
constexpr bool can_be_told(const CivilTime& time) {
  return time.year >= first_year && time.year <= last_year && time.day >= 1 &&
         time.day <= cia447::days_of_month(time.year, time.month) && time.hour <= 23 &&
         time.minute <= 59 && time.second <= 59;
}

/// Seconds end with 59.75: a leap second is reported as the second before it (9.2.6.15).
constexpr CivilTime without_leap_second(CivilTime time) {
  constexpr unsigned last_second = 59;
  if (time.second == last_second + 1) time.second = last_second;
  return time;
}

/// The six handles of a clock: year, day, month, hour, minute, second.
template <class Year, class Day, class Month, class Hour, class Minute, class Second>
struct ClockHandles {
  Year year;      ///< from 1985 on
  Day day;        ///< 1 to 31, in quarters
  Month month;    ///< 1 to 12
  Hour hour;      ///< 0 to 23
  Minute minute;  ///< 0 to 59
  Second second;  ///< in quarters, below 60
};
/// Deduces the types of the six handles.
template <class... Handles>
ClockHandles(Handles...) -> ClockHandles<Handles...>;

/// 610Eh.
inline constexpr ClockHandles local_clock{local_year, local_day,    local_month,
                                          local_hour, local_minute, local_second};
/// 6115h.
inline constexpr ClockHandles scheduled_clock{scheduled_year, scheduled_day,    scheduled_month,
                                              scheduled_hour, scheduled_minute, scheduled_second};
/// 6523h.
inline constexpr ClockHandles tachograph_clock{tachograph_year,   tachograph_day,
                                               tachograph_month,  tachograph_hour,
                                               tachograph_minute, tachograph_second};
/// 6680h.
inline constexpr ClockHandles universal_clock{universal_year, universal_day,    universal_month,
                                              universal_hour, universal_minute, universal_second};

/// For a value that has a code for "invalid".
template <class Reference>
concept MayBeNothing = requires(Reference reference) { reference = std::nullopt; };

/// Without a time, or with one that the object cannot hold, an object that has a code for "invalid"
/// (FFh) takes it, and others keep their value.
template <class Clock>
void report_clock(VirtualDevice& device, const Clock& clock, std::optional<CivilTime> time) {
  if (time) time = without_leap_second(*time);
  if (time && !can_be_told(*time)) time = std::nullopt;
  const auto tell = [&](const auto& handle, std::int64_t value) {
    using Reference = typename std::remove_cvref_t<decltype(handle)>::Reference;
    if (time) {
      device.tell(handle, static_cast<double>(value));
    } else if constexpr (MayBeNothing<Reference>) {
      device.tell(handle, std::nullopt);
    }
  };
  const CivilTime told = time.value_or(CivilTime{});
  tell(clock.year, told.year);
  tell(clock.day, told.day);
  if (time) {
    device.tell(clock.month, told.month);
  } else if constexpr (MayBeNothing<decltype(device[clock.month])>) {
    device.tell(clock.month, std::nullopt);
  }
  tell(clock.hour, told.hour);
  tell(clock.minute, told.minute);
  tell(clock.second, told.second);
}

/// Nothing if it is invalid or does not exist.
template <class Clock>
std::optional<CivilTime> read_clock(Values values, const Clock& clock) {
  const auto month = values[clock.month].value();
  const std::optional<double> year = values[clock.year].value();
  const std::optional<double> day = values[clock.day].value();
  const std::optional<double> hour = values[clock.hour].value();
  const std::optional<double> minute = values[clock.minute].value();
  const std::optional<double> second = values[clock.second].value();
  if (!month || !year || !day || !hour || !minute || !second) return std::nullopt;
  const CivilTime time = {.year = static_cast<std::int64_t>(*year),
                          .month = *month,
                          .day = static_cast<unsigned>(std::ceil(*day)),
                          .hour = static_cast<unsigned>(*hour),
                          .minute = static_cast<unsigned>(*minute),
                          .second = static_cast<unsigned>(*second)};
  return can_be_told(time) ? std::optional(time) : std::nullopt;
}
/// Local time of the vehicle (610Eh); nothing while it is not known.
inline std::optional<CivilTime> local_time(Values values) {
  return read_clock(values, local_clock);
}

}  // namespace canvoy::cia407
