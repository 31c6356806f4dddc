// The price of a trip, in the settings of a taximeter: tariffs with levels, and the hours and days
// at which each level applies. Money is in 0,001 of the local currency unit, as in 60D0h and 60D4h;
// distance in 0,001 of the local distance unit, as in 60D1h.
//
//     constexpr TariffLevel levels[] = {
//         {.name = {'1', ' '}, .initial_fare = 3900, .distance_rate = 2300, .time_rate = 33'000,
//          .increment = 100},                                               // day: 2,30 a km
//         {.name = {'2', ' '}, .initial_fare = 4400, .distance_rate = 2600, .time_rate = 33'000,
//          .increment = 100}};                                              // night and Sunday
//     constexpr TariffHours hours[] = {{.days = on_sundays, .level = 1},
//                                      {.from = time_of_day(22, 0), .to = time_of_day(6, 0), .level
//                                      = 1}};
//     constexpr Tariff tariff = {.id = 4711, .levels = levels, .hours = hours};
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia447 {

/// Prices of one level.
struct TariffLevel {
  std::array<char, 2> name = {};    ///< of 60D3h: characters 1 and 2; 0: none
  std::uint32_t initial_fare = 0;   ///< when the taxi is hired
  std::uint32_t minimum_fare = 0;   ///< minimum price of a trip, without supplements
  std::uint32_t distance_rate = 0;  ///< for a local distance unit
  std::uint32_t time_rate = 0;      ///< for an hour
  /// Single calculation mode: above it, distance is charged, below it, time. In 0,001 of the local
  /// distance unit per hour; 0: where both cost the same (time rate by distance rate).
  std::uint32_t crossover_speed = 0;
  /// The switching unit: the fare grows in steps of this amount. 0: 0,001.
  std::uint32_t increment = 0;
};

/// Days on which hours of a tariff apply: a bit for each Weekday, and one for holidays.
inline constexpr std::uint8_t on_mondays_to_fridays = 0x1F;
inline constexpr std::uint8_t on_saturdays = 0x20;  ///< bit of TariffHours::days
inline constexpr std::uint8_t on_sundays = 0x40;    ///< bit of TariffHours::days
inline constexpr std::uint8_t on_holidays = 0x80;   ///< bit of TariffHours::days
inline constexpr std::uint8_t on_all_days = 0xFF;   ///< all bits of TariffHours::days

/// Minutes of the day, up to 24:00.
constexpr std::uint16_t time_of_day(unsigned hour, unsigned minute) {
  return static_cast<std::uint16_t>(hour * 60 + minute);
}

/// Hours of a level. If `from` is not before `to`, they last over midnight, and belong to the day
/// on which they begin.
struct TariffHours {
  std::uint8_t days = on_all_days;         ///< bits 0 to 4: Monday to Friday
  std::uint16_t from = time_of_day(0, 0);  ///< minutes of the day
  std::uint16_t to = time_of_day(24, 0);   ///< not included
  std::uint8_t level = 0;                  ///< index in Tariff::levels
};

/// A holiday, which does not count as its day of the week. Year 0: each year.
struct Holiday {
  std::uint16_t year = 0;  ///< 0: each year
  std::uint8_t month = 1;  ///< 1 to 12
  std::uint8_t day = 1;    ///< 1 to 31
  /// The same day, in the same year or in each year.
  friend constexpr bool operator==(const Holiday&, const Holiday&) = default;
};

/// A service with an extra charge: luggage, a booking, the airport. The driver enters it by a key,
/// and it has a separate line on the receipt.
struct SupplementKind {
  std::string_view name = "";  ///< in ASCII; cut after 11 characters
  std::uint32_t price = 0;     ///< for each time
};
/// Maximum number in a tariff.
inline constexpr std::size_t supplement_kinds_max = 8;

struct Tariff {
  std::uint16_t id = 0;                      ///< of 60DAh sub-index 03h or 07h
  std::span<const TariffLevel> levels = {};  ///< the first is level 0
  std::span<const TariffHours> hours = {};   ///< the first that matches applies; none: level 0
  std::span<const Holiday> holidays = {};    ///< days that count as holidays
  std::span<const SupplementKind> supplements = {};  ///< any beyond 8 are ignored
};

/// Index in Tariff::levels of the level at a local time. A holiday is neither a day of the week nor
/// a Sunday: hours for Sundays and holidays name both.
unsigned level_at(const Tariff& tariff, std::int64_t local_seconds);

}  // namespace canvoy::cia447
