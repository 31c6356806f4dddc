#include "canvoy/worlds/lift/crowd_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::crowd_watch_test {
namespace {

/// Ten places, as people fill them.
CrowdWatch watch_of_ten() {
  Building building;
  building.lifts.resize(1);
  building.lifts[0].car.rated_persons = 10;
  return {building, {.fill_share = 1}};
}

TEST(CrowdWatchTest, MoreThanTwoCarsFullForFiveMinutesAreMoreThanLiftsCarry) {
  CrowdWatch sut = watch_of_ten();
  sut.look(Time(1min), false, 20);
  sut.look(Time(2min), false, 21);
  sut.look(Time(6min) - 1us, false, 21);
  EXPECT_FALSE(sut.is_saturated());
  sut.look(Time(6min), false, 21);
  EXPECT_TRUE(sut.is_saturated());
  sut.look(Time(7min), false, 0);
  EXPECT_TRUE(sut.is_saturated()) << "once is enough";
}

TEST(CrowdWatchTest, ACrowdThatSomethingHinderedSaysNothingOfLifts) {
  CrowdWatch sut = watch_of_ten();
  sut.look(Time(1min), false, 21);
  sut.look(Time(4min), true, 21);
  sut.look(Time(6min), false, 21);
  EXPECT_FALSE(sut.is_saturated());
  EXPECT_EQ(sut.hindered_at(), Time(4min));
}

TEST(CrowdWatchTest, ACrowdIsLeftByWhatHinderedItUntilAllCarsHoldIt) {
  CrowdWatch sut = watch_of_ten();
  sut.look(Time(1min), true, 30);
  for (int minute = 2; minute <= 20; ++minute) sut.look(Time(minute * 1min), false, 25);
  EXPECT_FALSE(sut.is_saturated());
  EXPECT_EQ(sut.excused_at(), Time(20min));
  sut.look(Time(21min), false, 10);
  sut.look(Time(22min), false, 25);
  sut.look(Time(27min), false, 25);
  EXPECT_EQ(sut.excused_at(), Time(20min)) << "they come by themselves";
  EXPECT_TRUE(sut.is_saturated());
}

TEST(CrowdWatchTest, ACrowdIsNotLeftForEver) {
  CrowdWatch sut = watch_of_ten();
  sut.look(Time(1min), true, 30);
  for (int minute = 2; minute <= 60; ++minute) sut.look(Time(minute * 1min), false, 25);
  EXPECT_EQ(sut.excused_at(), Time(30min));
  EXPECT_TRUE(sut.is_saturated());
}

}  // namespace
}  // namespace canvoy::lift::crowd_watch_test
