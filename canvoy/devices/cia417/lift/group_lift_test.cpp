// Estimates by hand: 1.5 s a floor, 8 s a stop.
#include "canvoy/devices/cia417/lift/group_lift.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::group_lift_test {
namespace {

constexpr auto up = Direction::up;
constexpr auto down = Direction::down;
constexpr TravelTimes times{.flight = 1500ms, .stop = 8s};

FloorSet floors(std::initializer_list<unsigned> list) {
  FloorSet set;
  for (const unsigned floor : list) set.insert(floor);
  return set;
}
Duration arrival(const Route& route, const Landing& landing) {
  return estimate_arrival(route, landing, times);
}

TEST(GroupLift, ServesAFloorByAllDoorsThatAreMeant) {
  const GroupLift lift{.served = {floors({1, 2, 3}), floors({3})}};
  EXPECT_TRUE(lift.serves(1, 0b01));
  EXPECT_FALSE(lift.serves(1, 0b11));
  EXPECT_TRUE(lift.serves(3, 0b11));
  EXPECT_FALSE(lift.serves(4, 0b01));
  EXPECT_FALSE(lift.serves(3, 0));
  EXPECT_FALSE(lift.serves(3, 0b1'0001)) << "a car has four doors";
  EXPECT_EQ(lift.doors_at(3), 0b11);
  EXPECT_EQ(lift.doors_at(254), 0);
}

TEST(GroupLift, LeavesAFloorWhereItHasAnotherOneInThatDirection) {
  const GroupLift lift{.served = {floors({2, 3}), floors({4})}};
  EXPECT_TRUE(lift.leaves(2, up));
  EXPECT_TRUE(lift.leaves(3, up)) << "to the other door's floor";
  EXPECT_FALSE(lift.leaves(4, up));
  EXPECT_TRUE(lift.leaves(4, down));
  EXPECT_FALSE(lift.leaves(2, down));
  EXPECT_TRUE(lift.leaves(4, Direction::none));
  EXPECT_FALSE(GroupLift{}.leaves(1, up));
  EXPECT_FALSE(GroupLift{}.leaves(1, down));
}

TEST(GroupLift, AnIdleCarComesStraight) {
  EXPECT_EQ(arrival({.floor = 3}, {7, down}), 6s);
  EXPECT_EQ(arrival({.floor = 7}, {3, up}), 6s);
  EXPECT_EQ(arrival({.floor = 7}, {7, up}), 0s);
}

TEST(GroupLift, StopsOnTheWayCost) {
  const Route route{3, up, floors({4, 6, 9}), floors({5})};
  EXPECT_EQ(arrival(route, {7, up}), 6s + 16s) << "4 and 6, not 5, where it stops on its way down";
  EXPECT_EQ(arrival(route, {7, Direction::none}), 22s);
  EXPECT_EQ(arrival(route, {6, up}), 4500ms + 8s) << "the stop that is meant costs no time before";
}

TEST(GroupLift, WhoWantsBackWaitsForTheTurn) {
  const Route route{3, up, floors({6}), floors({5})};
  EXPECT_EQ(arrival(route, {4, down}), 4500ms + 8s + 3s + 8s) << "up to 6, and by 5 to 4";
  EXPECT_EQ(arrival(route, {2, down}), 4500ms + 8s + 6s + 8s);
  EXPECT_EQ(arrival(route, {9, down}), 9s + 8s) << "it turns there";
}

TEST(GroupLift, WhoWantsUpBehindTheCarWaitsForBothTurns) {
  const Route route{5, up, floors({7}), floors({1})};
  EXPECT_EQ(arrival(route, {3, up}), 3s + 8s + 9s + 8s + 3s) << "7, 1 and 3";
  EXPECT_EQ(arrival({5, down, floors({9}), floors({4})}, {8, down}),
            1500ms + 8s + 7500ms + 8s + 1500ms)
      << "4, 9 and 8";
}

TEST(GroupLift, WhereThoseBehindTheCarWantToGoItDoesNotGoBefore) {
  Route route{3, up, floors({5}), floors({5})};
  route.stops_of({1, up}).insert(1);
  route.stops_of({1, up}).insert(20);
  EXPECT_EQ(route.stops_later, floors({1, 20}));
  EXPECT_EQ(arrival(route, {1, up}), 3s + 8s + 6s) << "5 and 1, not by 20";
  EXPECT_EQ(arrival(route, {2, up}), 3s + 8s + 6s + 8s + 1500ms) << "5, 1 and 2";
  EXPECT_EQ(arrival(route, {9, up}), 9s + 8s);
}

TEST(GroupLift, TheStopsOfALandingAreThoseOfTheWayOnWhichItComesThere) {
  Route route{.floor = 5, .direction = down};
  EXPECT_EQ(&route.stops_of({5, down}), &route.stops_down);
  EXPECT_EQ(&route.stops_of({6, down}), &route.stops_later);
  EXPECT_EQ(&route.stops_of({6, up}), &route.stops_up);
  EXPECT_EQ(&route.stops_of({4, up}), &route.stops_up);
  route.direction = Direction::none;
  EXPECT_EQ(&route.stops_of({6, down}), &route.stops_down);
}

TEST(GroupLift, ComesByWhatLiesAheadAndOnItsWayBack) {
  const GroupLift lift{.floor = 5, .direction = up};
  EXPECT_TRUE(comes_by(lift, {5, up}));
  EXPECT_TRUE(comes_by(lift, {9, up}));
  EXPECT_FALSE(comes_by(lift, {4, up})) << "after two turns";
  EXPECT_TRUE(comes_by(lift, {9, down}));
  EXPECT_TRUE(comes_by(lift, {4, down}));
  EXPECT_TRUE(comes_by({.floor = 5}, {4, up})) << "it waits for whoever comes";
}

}  // namespace
}  // namespace canvoy::cia417::group_lift_test
