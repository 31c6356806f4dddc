#include "canvoy/worlds/lift/car_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::car_watch_test {
namespace {

LiftFacts car_at(double position_m, double speed_m_s = 0, double open_m = 0) {
  LiftFacts facts{.position_m = position_m, .speed_m_s = speed_m_s};
  facts.doors[0].open_m = open_m;
  return facts;
}

class CarWatchTest : public testing::Test {
 protected:
  /// Floors are 3 m high: floor 2 is at 3 m.
  const Building building = uniform_building({.floors = 3, .floor_height_m = 3, .lifts = 2});
  std::vector<LiftEvent> events;
  CarWatch sut{building, events};
};

TEST_F(CarWatchTest, AStartIsToldWithTheFloorThatTheCarLeaves) {
  EXPECT_TRUE(sut.look(Time(1s), 1, car_at(3), 0).stands);
  const CarWatch::Seen seen = sut.look(Time(2s), 1, car_at(3.2, 0.5), 4);
  EXPECT_TRUE(seen.starts);
  EXPECT_FALSE(seen.stands);
  ASSERT_EQ(events.size(), 1U);
  const auto& started = std::get<CarStarted>(events[0].what);
  EXPECT_EQ(events[0].at, Time(2s));
  EXPECT_EQ(started.floor, 2);
  EXPECT_EQ(started.persons, 4U);
  EXPECT_FALSE(sut.look(Time(3s), 1, car_at(4, 1), 4).starts) << "it is on its way";
  EXPECT_EQ(sut.starts(1), 1U);
  EXPECT_EQ(sut.starts(2), 0U);
}

TEST_F(CarWatchTest, AStopBetweenTwoFloorsHasNone) {
  sut.look(Time(1s), 2, car_at(3, 1), 0);
  sut.look(Time(2s), 2, car_at(4.5), 0);
  EXPECT_EQ(std::get<CarStopped>(events.back().what).floor, no_floor);
}

TEST_F(CarWatchTest, ADoorIsNotedWhereAndWhenItWasOpened) {
  sut.look(Time(1s), 1, car_at(3), 0);
  EXPECT_FALSE(sut.has_opened_since(Time{}, 1, 2));
  sut.look(Time(2s), 1, car_at(3, 0, 0.5), 0);
  sut.look(Time(5s), 1, car_at(3, 0, 0.8), 0);
  EXPECT_EQ(std::get<DoorsOpened>(events.back().what).floor, 2);
  EXPECT_EQ(events.size(), 1U) << "it is open already";
  EXPECT_TRUE(sut.has_opened_since(Time(2s), 1, 2));
  EXPECT_FALSE(sut.has_opened_since(Time(3s), 1, 2));
  EXPECT_FALSE(sut.has_opened_since(Time{}, 1, 1));
  EXPECT_FALSE(sut.has_opened_since(Time{}, 2, 2));
}

}  // namespace
}  // namespace canvoy::lift::car_watch_test
