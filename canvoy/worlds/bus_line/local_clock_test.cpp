// Central European time in 2026: summer time from March 29 to October 25, both at 01:00 UTC.
#include "canvoy/worlds/bus_line/local_clock.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::local_clock_test {
namespace {

using std::chrono::year;

constexpr EpochSeconds spring = 1'774'746'000;  // date -u -d '2026-03-29 01:00' +%s
constexpr EpochSeconds autumn = 1'792'890'000;  // date -u -d '2026-10-25 01:00' +%s
constexpr std::int64_t hour = 3600;

LocalClock berlin() {
  return LocalClock({{.since = 0, .offset = hour},
                     {.since = spring, .offset = 2 * hour},
                     {.since = autumn, .offset = hour}});
}

TEST(LocalClock, IsSetWhereAnOffsetBegins) {
  const LocalClock clock = berlin();
  EXPECT_EQ(clock.offset_at(-1), hour);
  EXPECT_EQ(clock.local(spring - 1), spring + hour - 1);
  EXPECT_EQ(clock.local(spring), spring + 2 * hour);
  EXPECT_EQ(clock.local(autumn - 1), autumn + 2 * hour - 1);
  EXPECT_EQ(clock.local(autumn), autumn + hour);
  EXPECT_EQ(clock.offset_at(autumn * 2), hour);
}

TEST(LocalClock, ADayOfServiceBeginsAtMidnight) {
  EXPECT_EQ(berlin().service_begin(year(2026) / 3 / 28), 1'774'652'400);  // 2026-03-27 23:00 UTC
  EXPECT_EQ(berlin().service_begin(year(2026) / 7 / 1), 1'782'856'800);   // 2026-06-30 22:00 UTC
}

// GTFS: noon minus 12 h.
TEST(LocalClock, ADayOnWhichClocksAreSetBeginsAnHourBesideMidnight) {
  EXPECT_EQ(berlin().service_begin(year(2026) / 3 / 29), 1'774'735'200);   // 2026-03-28 22:00 UTC
  EXPECT_EQ(berlin().local(1'774'735'200), 1'774'735'200 + hour);          // 23:00
  EXPECT_EQ(berlin().service_begin(year(2026) / 10 / 25), 1'792'882'800);  // 2026-10-24 23:00 UTC
  EXPECT_EQ(berlin().local(1'792'882'800), 1'792'882'800 + 2 * hour);      // 01:00
}

// Noon there comes before midnight in Greenwich, and the other way round.
TEST(LocalClock, FarFromGreenwichADayBeginsThere) {
  const LocalClock kiritimati({OffsetChange{.offset = 14 * hour}});
  EXPECT_EQ(kiritimati.service_begin(year(1970) / 1 / 2), 10 * hour);
  const LocalClock niue({OffsetChange{.offset = -11 * hour}});
  EXPECT_EQ(niue.service_begin(year(1970) / 1 / 2), 35 * hour);
}

}  // namespace
}  // namespace canvoy::bus_line::local_clock_test
