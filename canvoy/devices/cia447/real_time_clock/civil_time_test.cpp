#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace canvoy::cia447::civil_time_test {
namespace {

TEST(CivilTime, IsCountedInSecondsSince1970) {
  EXPECT_EQ(seconds_since_1970({}), 0);
  EXPECT_EQ(seconds_since_1970({.year = 2009, .month = 1, .day = 1}), 1'230'768'000);
  EXPECT_EQ(seconds_since_1970(
                {.year = 2038, .month = 1, .day = 19, .hour = 3, .minute = 14, .second = 7}),
            0x7FFF'FFFF);
  EXPECT_EQ(seconds_since_1970({.year = 1969, .month = 12, .day = 31, .hour = 23}), -3600);
}

TEST(CivilTime, ComesBackFromEverySecondThatIsTried) {
  for (std::int64_t seconds = -70'000'000'000; seconds < 2'000'000'000'000;
       seconds += 1'234'567'891) {
    EXPECT_EQ(seconds_since_1970(civil_time(seconds)), seconds);
  }
}

/// The standard library supports years up to 32767.
TEST(CivilTime, AgreesWithTheLibrary) {
  for (int day = -800'000; day < 11'000'000; day += 97) {
    const std::chrono::sys_days days{std::chrono::days(day)};
    const std::chrono::year_month_day date(days);
    const CivilTime found = civil_time(day * seconds_a_day + 5);
    ASSERT_EQ(found.year, int{date.year()});
    ASSERT_EQ(found.month, unsigned{date.month()});
    ASSERT_EQ(found.day, unsigned{date.day()});
    ASSERT_EQ(found.second, 5u);
    ASSERT_EQ(static_cast<unsigned>(weekday_of(day)) + 1,
              std::chrono::weekday(days).iso_encoding());
  }
}

TEST(CivilTime, MonthsHaveTheirDays) {
  EXPECT_EQ(days_of_month(2000, 2), 29u);
  EXPECT_EQ(days_of_month(1900, 2), 28u);
  EXPECT_EQ(days_of_month(2024, 2), 29u);
  EXPECT_EQ(days_of_month(2025, 2), 28u);
  EXPECT_EQ(days_of_month(2025, 4), 30u);
  EXPECT_EQ(days_of_month(2025, 12), 31u);
  EXPECT_EQ(days_of_month(2025, 0), 0u);
  EXPECT_EQ(days_of_month(2025, 13), 0u);
}

}  // namespace
}  // namespace canvoy::cia447::civil_time_test
