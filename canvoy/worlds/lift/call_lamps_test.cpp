#include "canvoy/worlds/lift/call_lamps.hpp"

#include <gtest/gtest.h>

namespace canvoy::lift::call_lamps_test {
namespace {

constexpr CallKey hall{.floor = 3, .direction = Direction::up};

TEST(CallLampsTest, ACallIsLitAsLongAsOnePanelOfItsLandingShowsIt) {
  using enum CallLamps::Change;
  CallLamps sut;
  EXPECT_EQ(sut.set(Time(1s), 1, hall, true), lit);
  EXPECT_EQ(sut.set(Time(2s), 2, hall, true), none);
  EXPECT_EQ(sut.set(Time(3s), 1, hall, false), none);
  EXPECT_TRUE(sut.is_lit(hall));
  EXPECT_EQ(sut.set(Time(4s), 2, hall, false), dark);
  EXPECT_FALSE(sut.is_lit(hall));
  EXPECT_EQ(sut.set(Time(5s), 2, hall, false), none) << "told once more";
}

TEST(CallLampsTest, WhenItWasLitIsKnownAfterItHasGoneOut) {
  CallLamps sut;
  EXPECT_EQ(sut.lit_at(hall), never);
  sut.set(Time(1s), 1, hall, true);
  sut.set(Time(2s), 2, hall, true);
  sut.set(Time(3s), 1, hall, false);
  sut.set(Time(3s), 2, hall, false);
  EXPECT_EQ(sut.lit_at(hall), Time(1s));
  sut.set(Time(9s), 2, hall, true);
  EXPECT_EQ(sut.lit_at(hall), Time(9s));
}

TEST(CallLampsTest, LiftsShareACallOfALandingThatTheirPanelsShow) {
  CallLamps sut;
  sut.set(Time(1s), 1, hall, true);
  sut.set(Time(1s), 2, {.floor = 4, .direction = Direction::up}, true);
  EXPECT_FALSE(sut.are_shared());
  sut.set(Time(2s), 2, hall, true);
  EXPECT_TRUE(sut.are_shared());
}

TEST(CallLampsTest, CallsOfACarAreThoseOfItsLiftLowestFirst) {
  CallLamps sut;
  sut.set(Time(1s), 2, {.lift = 2, .floor = 7}, true);
  sut.set(Time(2s), 2, {.lift = 2, .floor = 5}, true);
  sut.set(Time(3s), 1, {.lift = 1, .floor = 6}, true);
  sut.set(Time(4s), 2, hall, true);
  EXPECT_EQ(sut.car_calls(2), (std::vector<FloorNumber>{5, 7}));
}

}  // namespace
}  // namespace canvoy::lift::call_lamps_test
