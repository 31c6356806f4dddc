#include "canvoy/canopen/sync/time_of_day.hpp"

#include <gtest/gtest.h>

namespace canvoy::time_of_day_test {
namespace {

using namespace std::chrono_literals;
using std::chrono::sys_days;

// Days since 1 January 1984, counted by Python's datetime.
struct Date {
  int year;
  unsigned month;
  unsigned day;
  std::uint16_t days;
};
constexpr Date dates[] = {{1984, 1, 1, 0},      {1984, 2, 29, 59},     {2000, 1, 1, 5844},
                          {2024, 2, 29, 14669}, {2026, 11, 21, 15665}, {2100, 3, 1, 42428},
                          {2163, 6, 6, 65535}};

sys_days day_of(const Date& date) {
  return std::chrono::year(date.year) / std::chrono::month(date.month) / std::chrono::day(date.day);
}

TEST(TimeOfDay, CountsDaysFrom1January1984) {
  for (const Date& date : dates) {
    const TimeOfDay midnight{.milliseconds = 0, .days = date.days};
    EXPECT_EQ(to_civil_time(midnight), day_of(date)) << date.days;
    EXPECT_EQ(to_time_of_day(day_of(date)), midnight) << date.days;
  }
}

TEST(TimeOfDay, CountsMillisecondsFromMidnight) {
  const CivilTime time = day_of(dates[4]) + 23h + 59min + 59s + 999ms;
  EXPECT_EQ(to_time_of_day(time), (TimeOfDay{.milliseconds = 86'399'999, .days = 15665}));
  EXPECT_EQ(to_time_of_day(time + 1ms), (TimeOfDay{.milliseconds = 0, .days = 15666}));
  EXPECT_EQ(to_civil_time({.milliseconds = 86'399'999, .days = 15665}), time);
}

TEST(TimeOfDay, HasNoTimeBeforeDay0AndAfterTheLastThat16BitsCount) {
  EXPECT_EQ(to_time_of_day(day_of(dates[0]) - 1ms), std::nullopt);
  EXPECT_EQ(to_time_of_day(sys_days(day_of(dates[6])) + 24h - 1ms),
            (TimeOfDay{.milliseconds = 86'399'999, .days = 65535}));
  EXPECT_EQ(to_time_of_day(sys_days(day_of(dates[6])) + 24h), std::nullopt);
}

TEST(TimeOfDay, EndsBeforeMidnight) {
  EXPECT_TRUE(TimeOfDay{.milliseconds = 86'399'999}.valid());
  EXPECT_FALSE(TimeOfDay{.milliseconds = 86'400'000}.valid());
  EXPECT_FALSE(TimeOfDay{.milliseconds = 0x0FFF'FFFF}.valid());
}

// 43,200,000 ms are 02932E00h.
TEST(TimeOfDay, StandsOnTheWireWith28BitsOfMillisecondsThen16BitsOfDays) {
  constexpr TimeOfDay noon{.milliseconds = 43'200'000, .days = 15665};
  constexpr TimeOfDayBytes bytes = {0x00, 0x2E, 0x93, 0x02, 0x31, 0x3D};
  EXPECT_EQ(encode_time(noon), bytes);
  EXPECT_EQ(decode_time<TimeOfDay>(bytes), noon);
}

TEST(TimeOfDay, SendsItsReservedBitsAs0AndLeavesThemOutWhenRead) {
  constexpr TimeOfDayBytes bytes = {0x01, 0x00, 0x00, 0xF0, 0x02, 0x00};
  EXPECT_EQ(decode_time<TimeOfDay>(bytes), (TimeOfDay{.milliseconds = 1, .days = 2}));
  EXPECT_EQ(encode_time(TimeOfDay{.milliseconds = 0xFFFF'FFFF, .days = 0xFFFF}),
            (TimeOfDayBytes{0xFF, 0xFF, 0xFF, 0x0F, 0xFF, 0xFF}));
}

TEST(TimeDifference, HasTheSameForm) {
  constexpr TimeDifference span{.milliseconds = 0x0ABC'DEF0, .days = 0x1234};
  constexpr TimeOfDayBytes bytes = {0xF0, 0xDE, 0xBC, 0x0A, 0x34, 0x12};
  EXPECT_EQ(encode_time(span), bytes);
  EXPECT_EQ(decode_time<TimeDifference>(bytes), span);
}

}  // namespace
}  // namespace canvoy::time_of_day_test
