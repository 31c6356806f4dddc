#include "canvoy/devices/cia447/real_time_clock/time_zone.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia447::time_zone_test {
namespace {

constexpr TimeZone berlin = {.name = "CET", .offset_minutes = 60, .summer = european_summer};
constexpr TimeZone new_york = {.name = "EST", .offset_minutes = -300, .summer = american_summer};
/// From the first Sunday of October at 2:00 to the first Sunday of April at 3:00.
constexpr TimeZone sydney = {.name = "AEST",
                             .offset_minutes = 600,
                             .summer = SummerTime{.begin = {.month = 10, .week = 1, .minute = 120},
                                                  .end = {.month = 4, .week = 1, .minute = 180},
                                                  .is_in_utc = false}};

std::int64_t utc(std::int64_t year, unsigned month, unsigned day, unsigned hour,
                 unsigned minute = 0, unsigned second = 0) {
  return seconds_since_1970({year, month, day, hour, minute, second});
}

TEST(TimeZone, SummerBeginsAndEndsInEuropeAtOneUtc) {
  EXPECT_FALSE(is_summer(berlin, utc(2026, 3, 29, 0, 59, 59)));
  EXPECT_TRUE(is_summer(berlin, utc(2026, 3, 29, 1)));
  EXPECT_TRUE(is_summer(berlin, utc(2026, 10, 25, 0, 59, 59)));
  EXPECT_FALSE(is_summer(berlin, utc(2026, 10, 25, 1)));
  EXPECT_EQ(ahead_of_utc(berlin, utc(2026, 7, 1, 0)), 7200);
  EXPECT_EQ(ahead_of_utc(berlin, utc(2026, 12, 31, 23, 30)), 3600);
}

TEST(TimeZone, SummerBeginsAndEndsInAmericaAtTwoByTheClock) {
  EXPECT_FALSE(is_summer(new_york, utc(2026, 3, 8, 6, 59, 59)));
  EXPECT_TRUE(is_summer(new_york, utc(2026, 3, 8, 7)));
  EXPECT_TRUE(is_summer(new_york, utc(2026, 11, 1, 5, 59, 59)));
  EXPECT_FALSE(is_summer(new_york, utc(2026, 11, 1, 6)));
}

TEST(TimeZone, SummerGoesOverTheTurnOfTheYearInTheSouth) {
  EXPECT_TRUE(is_summer(sydney, utc(2026, 1, 1, 0)));
  EXPECT_TRUE(is_summer(sydney, utc(2026, 4, 4, 15, 59, 59)));
  EXPECT_FALSE(is_summer(sydney, utc(2026, 4, 4, 16)));
  EXPECT_FALSE(is_summer(sydney, utc(2026, 10, 3, 15, 59, 59)));
  EXPECT_TRUE(is_summer(sydney, utc(2026, 10, 3, 16)));
}

TEST(TimeZone, TheHourThatThereIsTwiceIsTheOneThatIsMeant) {
  const std::int64_t twice = utc(2026, 10, 25, 2, 30);
  EXPECT_EQ(utc_of(berlin, twice, true), utc(2026, 10, 25, 0, 30));
  EXPECT_EQ(utc_of(berlin, twice, false), utc(2026, 10, 25, 1, 30));
}

TEST(TimeZone, TheHourThatThereIsNotIsTakenAsWithoutSummerTime) {
  for (const bool prefers_summer : {false, true}) {
    EXPECT_EQ(utc_of(berlin, utc(2026, 3, 29, 2, 30), prefers_summer), utc(2026, 3, 29, 1, 30));
  }
}

TEST(TimeZone, EveryHourOfAYearComesBack) {
  for (const TimeZone& zone : {berlin, new_york, sydney, TimeZone{}}) {
    for (std::int64_t hour = 0; hour < 366 * 24; ++hour) {
      const std::int64_t moment = utc(2026, 1, 1, 0) + hour * 3600;
      const std::int64_t local = moment + ahead_of_utc(zone, moment);
      ASSERT_EQ(utc_of(zone, local, is_summer(zone, moment)), moment) << zone.name << hour;
    }
  }
}

}  // namespace
}  // namespace canvoy::cia447::time_zone_test
