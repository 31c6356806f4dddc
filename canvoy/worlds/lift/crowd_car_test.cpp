#include "canvoy/worlds/lift/crowd_car.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::crowd_car_test {
namespace {

constexpr Duration patience = 90s;

TEST(CrowdCar, IsStuckWhenItHasStoodOpenForThatLongWhateverElseChanges) {
  CrowdCar sut;
  CarView view{.floor = 3, .door = DoorView::open};
  sut.see(view, Time(10s));
  view.direction = Direction::up;
  view.overload = true;
  sut.see(view, Time(60s));
  EXPECT_FALSE(sut.is_stuck(Time(100s) - 1us, patience));
  EXPECT_TRUE(sut.is_stuck(Time(100s), patience));
  view.door = DoorView::closed;
  sut.see(view, Time(110s));
  EXPECT_FALSE(sut.is_stuck(Time(300s), patience)) << "nobody can leave it";
  view.door = DoorView::open;
  sut.see(view, Time(120s));
  EXPECT_FALSE(sut.is_stuck(Time(210s) - 1us, patience)) << "it has gone on";
  EXPECT_TRUE(sut.is_stuck(Time(210s), patience));
}

TEST(CrowdCar, HasADoorwayThatTheFirstOfManyBarsAndTheLastFrees) {
  CrowdCar sut;
  sut.see({.floor = 3, .doorway = 2, .door = DoorView::open}, Time(10s));
  EXPECT_TRUE(sut.enter_doorway());
  sut.see({.floor = 3, .doorway = 1, .door = DoorView::open}, Time(11s));
  EXPECT_FALSE(sut.enter_doorway());
  EXPECT_EQ(sut.barred_door(), 2) << "where the first one stands";
  EXPECT_FALSE(sut.leave_doorway());
  EXPECT_TRUE(sut.leave_doorway());
  EXPECT_TRUE(sut.enter_doorway());
  EXPECT_EQ(sut.barred_door(), 1);
}

}  // namespace
}  // namespace canvoy::lift::crowd_car_test
