// Cars that open at the main floor beside the one that answers a call: rules for all messages of
// lifts. Worked examples are in group_up_peak_test.cpp, by frames.
#include "canvoy/devices/cia417/group/up_peak.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include "canvoy/can/random.hpp"

namespace canvoy::cia417::up_peak_test {
namespace {

struct MainFloor {
  explicit MainFloor(std::uint64_t seed) : random(seed) {
    for (GroupLift& lift : lifts) lift.served = {FloorSet::between(1, 10)};
  }
  void step() {
    now += Duration(random.below(3'000'000));
    const unsigned lift = 1 + random.below(8);
    GroupLift& state = lifts[lift - 1];
    switch (random.below(5)) {
      case 0:
        return up_peak.called(now, {.floor = static_cast<std::uint8_t>(1 + random.below(2)),
                                    .direction = Direction::up,
                                    .lifts = static_cast<LiftMask>(random.below(256))});
      case 1:
        return up_peak.opened(lift, {1, Direction::up});
      case 2:
        state.direction = static_cast<Direction>(static_cast<int>(random.below(3)) - 1);
        return up_peak.told(now, lift, random.below(2) == 0);
      case 3:
        state.floor = static_cast<std::uint8_t>(1 + random.below(3));
        return;
      default:
        state.in_service = random.below(4) != 0;
    }
  }

  Random random;
  UpPeakSettings settings{.cars_max = random.below(5), .in_a_row = 1 + random.below(2)};
  std::array<GroupLift, 8> lifts{};
  UpPeak up_peak{lifts, settings};
  Time now{};
};

RC_GTEST_PROP(UpPeakProperty, OnlyWhatStandsThereReadyIsAskedAndNoMoreThanAreWanted,
              (std::uint64_t seed)) {
  MainFloor world(seed);
  LiftMask outstanding = 0;
  for (unsigned i = 0; i < 300; ++i) {
    world.step();
    const auto busy = static_cast<LiftMask>(world.random.below(256));
    const LiftMask wanted = world.up_peak.call_more(busy);
    if (wanted == 0) continue;
    RC_ASSERT(world.up_peak.is_crowded());
    RC_ASSERT(world.settings.cars_max > 1U);
    // One fills already.
    RC_ASSERT(static_cast<unsigned>(std::popcount(wanted)) < world.settings.cars_max);
    for (unsigned lift = 1; lift <= 8; ++lift) {
      const bool is_new = (wanted & ~outstanding & lift_bit(lift)) != 0;
      if (!is_new) continue;
      const GroupLift& state = world.lifts[lift - 1];
      RC_ASSERT(state.in_service);
      RC_ASSERT(state.floor == 1);
      RC_ASSERT(state.direction == Direction::none);
      RC_ASSERT((busy & lift_bit(lift)) == 0);
      RC_ASSERT((world.up_peak.call().lifts & lift_bit(lift)) != 0);
    }
    RC_ASSERT(world.up_peak.call_more(busy) == 0);
    outstanding = wanted;
  }
}

TEST(UpPeakTest, ItsCallIsThatOfThePeopleWithLowPriority) {
  std::array<GroupLift, 1> lifts{};
  UpPeak up_peak(lifts, {.main_floor = 3});
  const HallCall call{.floor = 3, .direction = Direction::up, .doors = 0b10, .lifts = 0b11};
  up_peak.called(Time(1s), call);
  HallCall expected = call;
  expected.priority = CallPriority::low;
  EXPECT_EQ(up_peak.call(), expected);
}

TEST(UpPeakTest, CarsThatLeavePeopleBehindCountWhereNoneBetweenThemDoesNot) {
  const HallCall call{.floor = 1, .direction = Direction::up};
  std::array<GroupLift, 1> lifts{};
  UpPeak up_peak(lifts, {.left_behind = 2s, .in_a_row = 2});
  Time now{};
  const auto leaves_and_is_called_after = [&](Duration pause) {
    up_peak.opened(1, {1, Direction::up});
    up_peak.told(now += 60s, 1, true);
    up_peak.called(now + pause, call);
    return up_peak.is_crowded();
  };
  EXPECT_FALSE(leaves_and_is_called_after(1s));
  EXPECT_FALSE(leaves_and_is_called_after(3s));
  EXPECT_FALSE(leaves_and_is_called_after(1s));
  EXPECT_TRUE(leaves_and_is_called_after(2s));
  EXPECT_TRUE(leaves_and_is_called_after(1s));
  EXPECT_FALSE(leaves_and_is_called_after(3s));
}

TEST(UpPeakTest, AfterAResetNothingIsKnown) {
  std::array<GroupLift, 2> lifts{};
  for (GroupLift& lift : lifts) {
    lift.in_service = true;
    lift.served = {FloorSet::between(1, 10)};
  }
  const HallCall call{.floor = 1, .direction = Direction::up};
  UpPeak up_peak(lifts, {.in_a_row = 1});
  up_peak.opened(1, {1, Direction::up});
  up_peak.told(Time(10s), 1, true);
  up_peak.called(Time(11s), call);
  EXPECT_TRUE(up_peak.is_crowded());
  up_peak.reset();
  EXPECT_FALSE(up_peak.is_crowded());
  up_peak.called(Time(11s), call);
  EXPECT_FALSE(up_peak.is_crowded());
}

}  // namespace
}  // namespace canvoy::cia417::up_peak_test
