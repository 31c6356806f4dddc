// The database of time zones against the rules: clocks are set at 01:00 UTC in Europe, at 02:00
// local time in Newfoundland, on the second Sunday of March there.
#include "canvoy/tools/play/time_zone.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace canvoy::tools::time_zone_test {
namespace {

using bus_line::OffsetChange;
using std::chrono::days;
using std::chrono::sys_days;
using std::chrono::year;

std::vector<OffsetChange> changes_of(const std::string& zone, sys_days first, days length) {
  return offsets_of(zone, first, length).value_or(std::vector<OffsetChange>{});
}

class TimeZone : public testing::Test {
 protected:
  void SetUp() override {
    if (!offsets_of("Europe/Berlin", sys_days(year(2026) / 1 / 1), days(1))) {
      GTEST_SKIP() << "there is no database of time zones: apt install tzdata";
    }
  }
};

TEST_F(TimeZone, SummerTimeIsFromTheLastSundayOfMarchToThatOfOctober) {
  const std::vector<OffsetChange> expected = {{1'767'225'600, 3600},   // 2026-01-01 00:00 UTC
                                              {1'774'746'000, 7200},   // 2026-03-29 01:00 UTC
                                              {1'792'890'000, 3600}};  // 2026-10-25 01:00 UTC
  EXPECT_EQ(changes_of("Europe/Berlin", sys_days(year(2026) / 1 / 1), days(365)), expected);
}

// Files of the database have transitions up to 2037, and a rule for later ones.
TEST_F(TimeZone, SoItIsBeyond2037) {
  const std::vector<OffsetChange> expected = {{4'099'766'400, 3600},   // 2099-12-01 00:00 UTC
                                              {4'109'878'800, 7200}};  // 2100-03-28 01:00 UTC
  EXPECT_EQ(changes_of("Europe/Berlin", sys_days(year(2099) / 12 / 1), days(150)), expected);
}

TEST_F(TimeZone, WestOfGreenwichOffsetsAreNegativeAndNotAlwaysWholeHours) {
  const std::vector<OffsetChange> expected = {{1'772'323'200, -12'600},  // 2026-03-01 00:00 UTC
                                              {1'772'947'800, -9'000}};  // 2026-03-08 05:30 UTC
  EXPECT_EQ(changes_of("America/St_Johns", sys_days(year(2026) / 3 / 1), days(30)), expected);
}

TEST_F(TimeZone, WhoeverSetsNoClocksHasOneOffset) {
  EXPECT_EQ(changes_of("Asia/Kolkata", sys_days(year(2026) / 1 / 1), days(400)),
            (std::vector<OffsetChange>{{1'767'225'600, 19'800}}));
}

TEST_F(TimeZone, TheZoneOfTheProcessStaysWhatItWas) {
  ::setenv("TZ", "Asia/Tokyo", 1);
  EXPECT_TRUE(offsets_of("Europe/Berlin", sys_days(year(2026) / 1 / 1), days(1)));
  EXPECT_STREQ(std::getenv("TZ"), "Asia/Tokyo");
  ::unsetenv("TZ");
  EXPECT_TRUE(offsets_of("Europe/Berlin", sys_days(year(2026) / 1 / 1), days(1)));
  EXPECT_EQ(std::getenv("TZ"), nullptr);
}

TEST(TimeZoneName, WhatIsNoNameOfTheDatabaseIsNotKnown) {
  for (const char* name :
       {"", "Europe/Atlantis", "Europe", "CET-1", "/etc/passwd", "../../etc/passwd",
        "Europe/../Europe/Berlin", "Europe/Berlin ", "zone.tab", ":UTC"}) {
    EXPECT_FALSE(offsets_of(name, sys_days(year(2026) / 1 / 1), days(1))) << name;
  }
}

}  // namespace
}  // namespace canvoy::tools::time_zone_test
