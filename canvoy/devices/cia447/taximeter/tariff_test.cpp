#include "canvoy/devices/cia447/taximeter/tariff.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::tariff_test {
namespace {

constexpr TariffLevel levels[] = {{.name = {'1', 0}}, {.name = {'2', 0}}, {.name = {'3', 0}}};
constexpr TariffHours hours[] = {
    {.days = on_sundays | on_holidays, .level = 2},
    {.from = time_of_day(22, 0), .to = time_of_day(6, 0), .level = 1},
    {.days = on_saturdays, .from = time_of_day(12, 0), .to = time_of_day(14, 30), .level = 1}};
constexpr Holiday holidays[] = {{.month = 12, .day = 25}, {.year = 2026, .month = 4, .day = 6}};
constexpr Tariff tariff = {.id = 1, .levels = levels, .hours = hours, .holidays = holidays};

unsigned level(unsigned month, unsigned day, unsigned hour, unsigned minute, unsigned second = 0,
               std::int64_t year = 2026) {
  return level_at(tariff, seconds_since_1970({year, month, day, hour, minute, second}));
}

// 2026-11-23 is a Monday.
TEST(TariffHours, ChangeAtTenAtNight) {
  EXPECT_EQ(level(11, 23, 21, 59, 59), 0u);
  EXPECT_EQ(level(11, 23, 22, 0), 1u);
  EXPECT_EQ(level(11, 24, 0, 0), 1u);
  EXPECT_EQ(level(11, 24, 5, 59, 59), 1u);
  EXPECT_EQ(level(11, 24, 6, 0), 0u);
}

TEST(TariffHours, SundaysAreTheirOwnFromMidnightToMidnight) {
  EXPECT_EQ(level(11, 28, 23, 59, 59), 1u) << "Saturday night";
  EXPECT_EQ(level(11, 29, 0, 0), 2u);
  EXPECT_EQ(level(11, 29, 12, 0), 2u);
  EXPECT_EQ(level(11, 29, 23, 59), 2u) << "the first that fits";
  EXPECT_EQ(level(11, 30, 0, 0), 1u) << "the night of all days goes on";
}

TEST(TariffHours, WithinADayEndWhereTheySay) {
  EXPECT_EQ(level(11, 28, 11, 59), 0u);
  EXPECT_EQ(level(11, 28, 12, 0), 1u);
  EXPECT_EQ(level(11, 28, 14, 29), 1u);
  EXPECT_EQ(level(11, 28, 14, 30), 0u);
  EXPECT_EQ(level(11, 27, 12, 0), 0u) << "Friday";
}

TEST(TariffHours, HolidaysAreOfOneYearOrOfAll) {
  EXPECT_EQ(level(12, 25, 12, 0), 2u);
  EXPECT_EQ(level(12, 25, 12, 0, 0, 2027), 2u);
  EXPECT_EQ(level(4, 6, 12, 0), 2u);
  EXPECT_EQ(level(4, 6, 12, 0, 0, 2027), 0u);
}

TEST(TariffHours, ThatGoOverMidnightBelongToTheDayOnWhichTheyBegin) {
  static constexpr TariffHours friday_night[] = {
      {.days = 0x10, .from = time_of_day(20, 0), .to = time_of_day(4, 0), .level = 2}};
  static constexpr Tariff weekend = {.levels = levels, .hours = friday_night};
  const auto found = [&](unsigned day, unsigned hour) {
    return level_at(weekend, seconds_since_1970({2026, 11, day, hour, 0, 0}));
  };
  EXPECT_EQ(found(27, 3), 0u) << "Friday before dawn is Thursday's night";
  EXPECT_EQ(found(27, 20), 2u);
  EXPECT_EQ(found(28, 3), 2u);
  EXPECT_EQ(found(28, 4), 0u);
  EXPECT_EQ(found(28, 20), 0u);
}

TEST(TariffHours, OfALevelThatDoesNotExistDoNotHold) {
  static constexpr TariffHours wrong[] = {{.level = 3}, {.level = 1}};
  EXPECT_EQ(level_at({.levels = levels, .hours = wrong}, 0), 1u);
  EXPECT_EQ(level_at({.levels = levels}, 0), 0u);
}

}  // namespace
}  // namespace canvoy::cia447::tariff_test
