// What a trip costs, as the maker of a taximeter's settings writes it down: tariffs with levels,
// and the hours and days at which each level holds. Money is in 0,001 of the local currency unit,
// as in 60D0h and 60D4h; distance in 0,001 of the local distance unit, as in 60D1h.
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

#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

namespace canvoy::cia447 {

struct TariffLevel {
  std::array<char, 2> name = {};    ///< of 60D3h: characters 1 and 2; 0: none
  std::uint32_t initial_fare = 0;   ///< when the taxi is hired
  std::uint32_t minimum_fare = 0;   ///< the least that a trip costs, without supplements
  std::uint32_t distance_rate = 0;  ///< for a local distance unit
  std::uint32_t time_rate = 0;      ///< for an hour
  /// Single calculation mode: above it distance costs, below it time. In 0,001 of the local
  /// distance unit an hour; 0: where both cost the same (time rate by distance rate).
  std::uint32_t crossover_speed = 0;
  /// The switching unit: by so much the fare grows at a time, when so much has been used. 0: 0,001.
  std::uint32_t increment = 0;
};

/// Days on which hours of a tariff hold: a bit for each Weekday, and one for holidays.
inline constexpr std::uint8_t on_mondays_to_fridays = 0x1F;
inline constexpr std::uint8_t on_saturdays = 0x20;
inline constexpr std::uint8_t on_sundays = 0x40;
inline constexpr std::uint8_t on_holidays = 0x80;
inline constexpr std::uint8_t on_all_days = 0xFF;

/// Minutes of the day, up to 24:00.
constexpr std::uint16_t time_of_day(unsigned hour, unsigned minute) {
  return static_cast<std::uint16_t>(hour * 60 + minute);
}

/// When a level holds. Where `from` is not before `to` it goes over midnight, and belongs to the
/// day on which it begins.
struct TariffHours {
  std::uint8_t days = on_all_days;
  std::uint16_t from = time_of_day(0, 0);
  std::uint16_t to = time_of_day(24, 0);  ///< not included
  std::uint8_t level = 0;                 ///< its place in Tariff::levels
};

/// A day that is not what its name in the week says. Year 0: each year.
struct Holiday {
  std::uint16_t year = 0;
  std::uint8_t month = 1;
  std::uint8_t day = 1;
};

struct Tariff {
  std::uint16_t id = 0;  ///< of 60DAh sub-index 03h or 07h
  std::span<const TariffLevel> levels = {};
  std::span<const TariffHours> hours = {};  ///< the first that fits holds; none: level 0
  std::span<const Holiday> holidays = {};
};

/// The place in Tariff::levels of the level that holds at a local time. A holiday is neither a day
/// of the week nor a Sunday: hours that are to hold on Sundays and holidays say so.
unsigned level_at(const Tariff& tariff, std::int64_t local_seconds);

}  // namespace canvoy::cia447
