#include "canvoy/text/time_text.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canvoy/text/value_text.hpp"

namespace canvoy::text::time_text_test {
namespace {

TEST(TimeText, OfATimeOfDayIsItsDate) {
  EXPECT_EQ(time_text(TimeOfDay{.milliseconds = 0, .days = 0}), "1984-01-01 00:00:00.000");
  EXPECT_EQ(time_text(TimeOfDay{.milliseconds = 43'200'250, .days = 15'665}),
            "2026-11-21 12:00:00.250");
  EXPECT_EQ(time_text(TimeOfDay{.milliseconds = 86'399'999, .days = 65'535}),
            "2163-06-06 23:59:59.999");
  EXPECT_EQ(time_text(TimeOfDay{.milliseconds = 90'000'000, .days = 1}), "day 1, 90000000 ms");
}

TEST(TimeText, OfADifferenceIsItsDaysAndHours) {
  EXPECT_EQ(time_text(TimeDifference{.milliseconds = 3'723'004, .days = 3}), "3 d 01:02:03.004");
  EXPECT_EQ(time_text(TimeDifference{.milliseconds = 0x0FFF'FFFF, .days = 0}), "0 d 74:33:55.455");
}

TEST(TimeText, IsReadBack) {
  const TimeOfDay noon{.milliseconds = 43'200'250, .days = 15'665};
  EXPECT_EQ(parse_time_of_day("2026-11-21 12:00:00.250"), noon);
  EXPECT_EQ(parse_time_of_day("2026-11-21T12:00:00.25"), noon);
  EXPECT_EQ(parse_time_of_day("1984-2-29 0:01"), (TimeOfDay{.milliseconds = 60'000, .days = 59}));
  EXPECT_EQ(parse_time_difference("3 d 01:02:03.004"),
            (TimeDifference{.milliseconds = 3'723'004, .days = 3}));
  EXPECT_EQ(parse_time_difference("74:33:55.455"),
            (TimeDifference{.milliseconds = 0x0FFF'FFFF, .days = 0}));
  EXPECT_EQ(parse_time_difference("65535 d 0:00:00.1"),
            (TimeDifference{.milliseconds = 100, .days = 65'535}));
}

TEST(TimeText, ThatIsNoTimeIsRefused) {
  for (const char* text :
       {"", "noon", "2026-11-21", "2026-11-21 24:00", "2026-11-21 12:60", "2026-11-21 12:00:60",
        "2026-02-29 12:00", "2026-13-01 12:00", "2026-11-00 12:00", "2026-11-21 12:00:00.1234",
        "2026-11-21 12:00:00.", "2026-11-21 12:00 ", "1983-12-31 23:59", "2163-06-07 00:00",
        "-2026-11-21 12:00", "2026-11-21  12:00", "99999999999-01-01 12:00"}) {
    EXPECT_EQ(parse_time_of_day(text), std::nullopt) << text;
  }
  for (const char* text : {"", "1 d", "1 d ", "65536 d 00:00", "-1 d 00:00", "x d 00:00", "75:00",
                           "74:33:55.456", "12", "12:00:00.0000"}) {
    EXPECT_EQ(parse_time_difference(text), std::nullopt) << text;
  }
}

TEST(TimeText, IsHowAnEntryOfTheseTypesIsShown) {
  constexpr std::array<std::uint8_t, 6> noon = {0x00, 0x2E, 0x93, 0x02, 0x31, 0x3D};
  constexpr EntryInfo time = {.name = "Time", .type = DataType::time_of_day};
  EXPECT_EQ(value_text(&time, noon), "2026-11-21 12:00:00.000");
  EXPECT_EQ(value_text(&time, std::span(noon).first(5)), "00 2E 93 02 31");
  constexpr EntryInfo span = {.name = "Span", .type = DataType::time_difference};
  EXPECT_EQ(value_text(&span, noon), "15665 d 12:00:00.000");
}

}  // namespace
}  // namespace canvoy::text::time_text_test
