#include "canvoy/worlds/bus_line/line_clock.hpp"

#include <gtest/gtest.h>

namespace canvoy::bus_line::line_clock_test {
namespace {

constexpr std::int64_t noon = 43'200;  ///< s since 1970

/// Its own clock, an hour ahead of the satellites.
std::optional<cia407::CivilTime> hour_ahead() {
  return cia447::civil_time(noon + 3'600);
}

LineClock with_own_clock() {
  return LineClock(LineClock::OwnClock(
      [](void*) -> std::optional<cia407::CivilTime> { return hour_ahead(); }, nullptr));
}

std::optional<std::int64_t> shown(const LineClock& clock, Time now) {
  const auto time = clock.local(now);
  return time ? std::optional(cia447::seconds_since_1970(*time)) : std::nullopt;
}

TEST(LineClock, WhatIsHeardGoesOnByItself) {
  LineClock clock = with_own_clock();
  clock.begin(Time{});
  EXPECT_FALSE(clock.hear(noon, Time(1s)));
  EXPECT_EQ(shown(clock, Time(1s)), noon);
  EXPECT_EQ(shown(clock, Time(5s)), noon + 4);
}

TEST(LineClock, AMessageThatComesALittleLateChangesNothing) {
  LineClock clock = with_own_clock();
  clock.hear(noon, Time(1s));
  EXPECT_FALSE(clock.hear(noon + 1, Time(3s)));
  EXPECT_EQ(shown(clock, Time(3s)), noon + 2);
}

TEST(LineClock, ItJumpsWhereSummerTimeBegins) {
  LineClock clock = with_own_clock();
  clock.hear(noon, Time(1s));
  EXPECT_TRUE(clock.hear(noon + 3'601, Time(2s)));
  EXPECT_EQ(shown(clock, Time(2s)), noon + 3'601);
}

TEST(LineClock, ItsOwnClockWaitsForThatOfTheSatellites) {
  LineClock clock = with_own_clock();
  clock.begin(Time(10s));
  EXPECT_EQ(shown(clock, Time(12s)), std::nullopt);
  EXPECT_EQ(shown(clock, Time(13s)), noon + 3'600);
}

TEST(LineClock, ItsOwnClockIsTakenWhereSatellitesAreSilent) {
  LineClock clock = with_own_clock();
  clock.hear(noon, Time(1s));
  EXPECT_EQ(shown(clock, Time(5s)), noon + 4);
  EXPECT_EQ(shown(clock, Time(6s)), noon + 3'600);
}

TEST(LineClock, ItIsSaidOnceThatTheTimeHasComeOrGone) {
  LineClock clock{LineClock::OwnClock()};
  EXPECT_FALSE(clock.has_come_or_gone(Time(1s)));
  clock.hear(noon, Time(1s));
  EXPECT_TRUE(clock.has_come_or_gone(Time(1s)));
  EXPECT_FALSE(clock.has_come_or_gone(Time(2s)));
  EXPECT_TRUE(clock.has_come_or_gone(Time(6s)));
}

}  // namespace
}  // namespace canvoy::bus_line::line_clock_test
