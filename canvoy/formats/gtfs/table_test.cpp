#include "canvoy/formats/gtfs/table.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace canvoy::gtfs::table_test {
namespace {

using namespace std::chrono_literals;

TEST(Table, ATimeMayBeginWithOneDigitAndGoOnAfterMidnight) {
  EXPECT_EQ(parse_time("08:05:00"), 8h + 5min);
  EXPECT_EQ(parse_time("8:05:09"), 8h + 5min + 9s);
  EXPECT_EQ(parse_time("25:35:00"), 25h + 35min);
  EXPECT_EQ(parse_time("239:59:59"), 239h + 59min + 59s);
}

TEST(Table, WhatIsNoTimeIsNone) {
  for (const std::string_view text :
       {"", "8", "08:05", "08:5:00", "08:05:0", "08:60:00", "08:00:60", "240:00:00", "-1:00:00",
        "08:05:00 ", "08:05:00x", ":05:00", "+8:05:00", "08-05-00", "0x8:05:00", "08:05:0a",
        "99999999999:00:00"}) {
    EXPECT_EQ(parse_time(text), std::nullopt) << text;
  }
}

TEST(Table, ADateIsADayThatIsThere) {
  EXPECT_EQ(parse_date("20261123"), std::chrono::year(2026) / 11 / 23);
  EXPECT_EQ(parse_date("20240229"), std::chrono::year(2024) / 2 / 29);
  for (const std::string_view text :
       {"", "2026112", "202611231", "20260229", "20261301", "20260001", "2026-1-1", "2026112x"}) {
    EXPECT_EQ(parse_date(text), std::nullopt) << text;
  }
}

TEST(Table, ANumberIsAllOfTheTextAndFinite) {
  EXPECT_EQ(parse_number("-50.25"), -50.25);
  EXPECT_EQ(parse_number("+8"), 8.0);
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  for (const std::string_view text : {"", "inf", "nan", "1e999", "1,5", "5m", "--5", "0x10"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(Table, ColumnsAreFoundByTheirNamesInAnyOrder) {
  constexpr static std::string_view columns[] = {"a", "b", "c"};
  const FeedArchive archive = FeedArchive::of_texts({{"x.txt", "z,c,a\n1,2,3\n4,5\n6,7,8,,\n"}});
  host::Result<Table> table = Table::open(archive, "x.txt", columns);
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->has(0));
  EXPECT_FALSE(table->has(1));
  ASSERT_TRUE(table->next());
  EXPECT_EQ(table->text(0), "3");
  EXPECT_EQ(table->text(1), "");
  EXPECT_EQ(table->text(2), "2");
  ASSERT_TRUE(table->next());
  EXPECT_EQ(table->text(0), "");  // the row is short
  ASSERT_TRUE(table->next());     // commas at the end
  EXPECT_EQ(table->text(0), "8");
  EXPECT_FALSE(table->next());
  EXPECT_FALSE(table->error());
}

/// U+202E right-to-left override, U+200B zero width space, U+200F right-to-left mark, U+00AD soft
/// hyphen, U+FEFF byte order mark.
TEST(Table, WhatNobodyCanReadIsNoPartOfAName) {
  constexpr static std::string_view columns[] = {"a"};
  const FeedArchive archive = FeedArchive::of_texts(
      {{"x.txt",
        "a\nT\u202Ewo\u200B\n\u05D0\u200F 1\nT\x01w\x1Bo\x7F\n"
        "Bahn\u00ADhof\uFEFF\n\" One\r\n \tMore \"\n\u00E4\u2014\n\u0645\u06CC\u200C\u0634\n"}});
  host::Result<Table> table = Table::open(archive, "x.txt", columns);
  ASSERT_TRUE(table);
  for (const std::string_view name : {"Two", "\u05D0 1", "Two", "Bahnhof", "One More",
                                      "\u00E4\u2014", "\u0645\u06CC\u200C\u0634"}) {
    ASSERT_TRUE(table->next());
    EXPECT_EQ(table->shown(0), name);
  }
  EXPECT_FALSE(table->error());
}

TEST(Table, TheFirstThingThatIsWrongEndsIt) {
  constexpr static std::string_view columns[] = {"a"};
  const FeedArchive archive = FeedArchive::of_texts({{"x.txt", "a\n1\n2\n"}}, "feed.zip");
  host::Result<Table> table = Table::open(archive, "x.txt", columns);
  ASSERT_TRUE(table);
  ASSERT_TRUE(table->next());
  table->fail(0, "wrong");
  table->fail(0, "worse");
  EXPECT_FALSE(table->next());
  ASSERT_TRUE(table->error());
  EXPECT_EQ(table->error()->line(), "feed.zip/x.txt line 2: a: wrong");
}

}  // namespace
}  // namespace canvoy::gtfs::table_test
