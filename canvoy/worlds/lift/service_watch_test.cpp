#include "canvoy/worlds/lift/service_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::service_watch_test {
namespace {

LiftFacts at_m(double position_m, double open_m = 0) {
  LiftFacts facts{.position_m = position_m};
  facts.doors[0] = {.open_m = open_m, .locked = open_m == 0};
  return facts;
}

/// Two lifts with five floors 3.5 m apart; a passenger comes at 10 s who wants to go from floor 3
/// to floor 1.
struct LiftServiceWatchTest : testing::Test {
  void look_until(Time until, const LiftFacts& facts, bool is_hindered = false) {
    for (; now < until; now += 1s) {
      crowd.advance(now);
      sut.look(now, 1, facts, is_hindered, crowd);
    }
  }

  const Building building = uniform_building({.floors = 5, .lifts = 2});
  Crowd crowd{building, Traffic({{.at = Time(10s), .from = 3, .to = 1}}), {}};
  ServiceWatch sut{building};
  Time now{};
};

/// 7 m / 1.6 m/s + 1.6 / 1 s + 1 / 1.2 s, 2 s to open, and a minute: 68.8 s from 10 s on.
TEST_F(LiftServiceWatchTest, ALiftIsIdleFromWhenItCouldHaveCome) {
  look_until(Time(79s), at_m(0));
  EXPECT_EQ(sut.idle(1), 0s);
  EXPECT_FALSE(sut.was_wanted(1));
  look_until(Time(89s), at_m(0));
  EXPECT_EQ(sut.idle(1), 10s);
  EXPECT_TRUE(sut.was_wanted(1));
}

TEST_F(LiftServiceWatchTest, OneThatHasLeftItsFloorIsNot) {
  look_until(Time(89s), at_m(0));
  look_until(Time(90s), at_m(0.4));
  EXPECT_EQ(sut.idle(1), 11s) << "that was its door zone";
  look_until(Time(91s), at_m(0.6));
  EXPECT_EQ(sut.idle(1), 0s);
  EXPECT_TRUE(sut.was_wanted(1)) << "it came";
}

TEST_F(LiftServiceWatchTest, WhatHindersItExcusesIt) {
  look_until(Time(5min), at_m(0), true);
  look_until(Time(5min) + 68s, at_m(0));
  EXPECT_EQ(sut.idle(1), 0s) << "the time begins anew";
  look_until(Time(5min) + 78s, at_m(0));
  EXPECT_EQ(sut.idle(1), 10s);
}

TEST_F(LiftServiceWatchTest, NobodyComesFromAFloorThatItDoesNotServe) {
  Building high = building;
  high.lifts[0].floors = {1, 4, 5};
  ServiceWatch watch(high);
  for (; now < Time(5min); now += 1s) {
    crowd.advance(now);
    watch.look(now, 1, at_m(0), false, crowd);
    watch.look(now, 2, at_m(0), false, crowd);
  }
  EXPECT_EQ(watch.idle(1), 0s);
  EXPECT_GT(watch.idle(2), 3min);
}

TEST_F(LiftServiceWatchTest, PeopleBehindShutDoorsAreTrapped) {
  look_until(Time(12s), at_m(7));
  // The passenger steps in: the door is open, and reports it.
  crowd.car_changed(now, 1, {.floor = 3, .door = DoorView::open});
  look_until(Time(20s), at_m(7, 0.9));
  ASSERT_EQ(crowd.riding(1).size(), 1U);
  EXPECT_TRUE(sut.has_riders(1));
  EXPECT_EQ(sut.trapped(1), 0s) << "he can get out";
  look_until(Time(30s), at_m(7));
  EXPECT_EQ(sut.trapped(1), 10s);
  look_until(Time(40s), at_m(5, 0.9));
  EXPECT_EQ(sut.trapped(1), 20s) << "there is no floor";
  LiftFacts moving = at_m(5);
  moving.speed_m_s = 1;
  look_until(Time(41s), moving);
  EXPECT_EQ(sut.trapped(1), 0s);
  look_until(Time(60s), at_m(5), true);
  EXPECT_FALSE(sut.has_riders(1)) << "a fault excuses it";
}

}  // namespace
}  // namespace canvoy::lift::service_watch_test
