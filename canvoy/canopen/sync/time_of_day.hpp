// TIME_OF_DAY and TIME_DIFFERENCE in the form of the wire and of the dictionary, and conversion to
// dates (CiA 301, 7.1.6.5, 7.1.6.6 and 7.2.6).
//
//     using namespace std::chrono;
//     constexpr TimeOfDay leap_day = *to_time_of_day(sys_days{year{2024} / 2 / 29} + 12h);
//     static_assert(leap_day == TimeOfDay{.milliseconds = 43'200'000, .days = 14'669});
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/can/time.hpp"

namespace canvoy {

inline constexpr std::uint32_t milliseconds_per_day = 86'400'000;  ///< without leap seconds

/// A point in time: to the millisecond, from 1984 to 2163. CiA 301 defines no time zone; each
/// network agrees on its own.
struct TimeOfDay {
  std::uint32_t milliseconds = 0;  ///< since midnight
  std::uint16_t days = 0;          ///< since 1 January 1984

  /// True if the time is within a day: the field on the wire has room for three days.
  constexpr bool valid() const { return milliseconds < milliseconds_per_day; }
  friend constexpr bool operator==(const TimeOfDay&, const TimeOfDay&) = default;
};

/// A span of time, in the same form as TimeOfDay.
struct TimeDifference {
  std::uint32_t milliseconds = 0;  ///< may be a day or more
  std::uint16_t days = 0;          ///< added to the milliseconds

  friend constexpr bool operator==(const TimeDifference&, const TimeDifference&) = default;
};

/// Size on the wire: 28 bits of milliseconds, 4 reserved bits, 16 bits of days.
inline constexpr std::size_t time_of_day_bytes = 6;
using TimeOfDayBytes = std::array<std::uint8_t, time_of_day_bytes>;  ///< little-endian

/// Encodes a time with the reserved bits zero. `Type` is TimeOfDay or TimeDifference.
template <class Type>
constexpr TimeOfDayBytes encode_time(const Type& time) {
  const std::uint32_t milliseconds = time.milliseconds & 0x0FFF'FFFF;
  return {
      static_cast<std::uint8_t>(milliseconds),       static_cast<std::uint8_t>(milliseconds >> 8),
      static_cast<std::uint8_t>(milliseconds >> 16), static_cast<std::uint8_t>(milliseconds >> 24),
      static_cast<std::uint8_t>(time.days),          static_cast<std::uint8_t>(time.days >> 8)};
}

/// Decodes a time; ignores the reserved bits.
template <class Type>
constexpr Type decode_time(std::span<const std::uint8_t, time_of_day_bytes> bytes) {
  const std::uint32_t low = bytes[0] | std::uint32_t{bytes[1]} << 8;
  const std::uint32_t high = bytes[2] | std::uint32_t{bytes[3]} << 8;
  return {.milliseconds = (low | high << 16) & 0x0FFF'FFFF,
          .days = static_cast<std::uint16_t>(bytes[4] | bytes[5] << 8)};
}

/// A date and a time of day, as <chrono> counts them.
using CivilTime = std::chrono::sys_time<std::chrono::milliseconds>;

/// Day 0.
inline constexpr std::chrono::sys_days time_of_day_epoch{std::chrono::year{1984} / 1 / 1};

/// Converts any time, also one that is not valid().
constexpr CivilTime to_civil_time(const TimeOfDay& time) {
  return time_of_day_epoch + std::chrono::days(time.days) +
         std::chrono::milliseconds(time.milliseconds);
}

/// Converts a time; nothing if it is before 1984 or after 6 June 2163.
constexpr std::optional<TimeOfDay> to_time_of_day(CivilTime time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const auto days = (day - time_of_day_epoch).count();
  if (days < 0 || days > 0xFFFF) return {};
  return TimeOfDay{.milliseconds = static_cast<std::uint32_t>((time - day).count()),
                   .days = static_cast<std::uint16_t>(days)};
}

}  // namespace canvoy
