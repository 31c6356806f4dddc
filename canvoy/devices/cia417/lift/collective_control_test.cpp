// Full collective control: worked examples, and a car that moves from floor to floor among random
// calls.
#include "canvoy/devices/cia417/lift/collective_control.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/can/random.hpp"

namespace canvoy::cia417::collective_control_test {
namespace {

constexpr auto car = CallKind::car;
constexpr auto hall_up = CallKind::up;
constexpr auto hall_down = CallKind::down;
constexpr auto hall_any = CallKind::any;
using enum CallPriority;

LiftCalls make(std::initializer_list<Call> list) {
  LiftCalls calls;
  for (const Call& call : list) calls.add(call);
  return calls;
}
constexpr auto up = Direction::up;
constexpr auto down = Direction::down;
constexpr auto none = Direction::none;

TEST(CollectiveControl, WithoutCallsACarStays) {
  EXPECT_EQ(next_stop({}, {.floor = 3}), NextStop{});
  EXPECT_EQ(next_stop({}, {.floor = 3, .direction = up}), NextStop{});
}

TEST(CollectiveControl, AnIdleCarGoesToTheNearestCall) {
  const LiftCalls calls = make({{car, standard, 1, 1}, {hall_down, standard, 9, 1}});
  EXPECT_EQ(next_stop(calls, {.floor = 4}).floor, 1);
  EXPECT_EQ(next_stop(calls, {.floor = 6}).floor, 9);
  EXPECT_EQ(next_stop(calls, {.floor = 5}).floor, 9) << "up where both are as near";
}

TEST(CollectiveControl, AnIdleCarOpensWhereItIsCalled) {
  for (const CallKind kind : {car, hall_up, hall_down, hall_any}) {
    const LiftCalls calls = make({{kind, standard, 4, 0b10}, {car, standard, 9, 1}});
    const NextStop stop = next_stop(calls, {.floor = 4});
    EXPECT_EQ(stop.floor, 4);
    EXPECT_EQ(stop.doors, 0b10);
    EXPECT_EQ(stop.departure, kind == hall_down ? down : up);
  }
}

TEST(CollectiveControl, OnItsWayUpItStopsForThoseWhoGoUp) {
  const LiftCalls calls = make({{hall_down, standard, 3, 1},
                                {hall_up, standard, 4, 1},
                                {car, standard, 6, 1},
                                {hall_any, standard, 7, 1}});
  const CollectiveCar from{.floor = 2, .direction = up, .moving = true};
  EXPECT_EQ(next_stop(calls, from), (NextStop{4, up, 1})) << "not for 3, who wants down";
  EXPECT_EQ(next_stop(calls, {.floor = 5, .direction = up, .moving = true}), (NextStop{6, up, 1}));
  EXPECT_EQ(next_stop(calls, {.floor = 7, .direction = up, .moving = true}), (NextStop{7, down, 1}))
      << "the undirected call at 7 is the last";
}

TEST(CollectiveControl, ItTurnsAtTheHighestCallDown) {
  const LiftCalls calls = make({{hall_down, standard, 3, 1}, {hall_down, standard, 8, 1}});
  EXPECT_EQ(next_stop(calls, {.floor = 2, .direction = up, .moving = true}),
            (NextStop{8, down, 1}));
  EXPECT_EQ(next_stop(calls, {.floor = 7, .direction = down, .moving = true}),
            (NextStop{3, down, 1}));
}

TEST(CollectiveControl, ItTurnsAtTheLowestCallUp) {
  const LiftCalls calls = make({{hall_up, standard, 3, 1}, {hall_up, standard, 8, 1}});
  EXPECT_EQ(next_stop(calls, {.floor = 9, .direction = down, .moving = true}),
            (NextStop{3, up, 1}));
}

TEST(CollectiveControl, AtItsLastStopWithCallsBothWaysItTakesThoseOfItsDirectionFirst) {
  LiftCalls calls = make({{hall_up, standard, 5, 0b01}, {hall_down, standard, 5, 0b10}});
  EXPECT_EQ(next_stop(calls, {.floor = 2, .direction = up, .moving = true}),
            (NextStop{5, up, 0b01}));
  calls.remove_at(5, answered_calls(up));
  EXPECT_EQ(next_stop(calls, {.floor = 5, .direction = up}), (NextStop{5, down, 0b10}))
      << "nobody entered";
}

TEST(CollectiveControl, AMovingCarWithoutCallsEndsWhereItCan) {
  EXPECT_EQ(next_stop({}, {.floor = 5, .direction = up, .moving = true}), (NextStop{5, none, 0}));
  const LiftCalls behind = make({{car, standard, 2, 1}});
  EXPECT_EQ(next_stop(behind, {.floor = 5, .direction = up, .moving = true}),
            (NextStop{5, none, 0}))
      << "it does not turn on the way";
  EXPECT_EQ(next_stop(behind, {.floor = 5, .direction = up}), (NextStop{2, none, 1}));
}

TEST(CollectiveControl, AFullCarPassesHallCallsAndKeepsThem) {
  const LiftCalls calls = make({{hall_up, standard, 4, 1}, {car, standard, 6, 1}});
  const CollectiveCar full{.floor = 2, .direction = up, .moving = true, .takes_hall_calls = false};
  EXPECT_EQ(next_stop(calls, full), (NextStop{6, none, 1}));
  EXPECT_TRUE(calls.contains({hall_up, standard, 4, 1}));
}

TEST(CollectiveControl, HighPriorityComesFirst) {
  LiftCalls calls = make({{car, standard, 3, 1}, {hall_up, high, 8, 1}, {car, low, 1, 1}});
  const CollectiveCar from{.floor = 2, .direction = up, .moving = true};
  EXPECT_EQ(next_stop(calls, from), (NextStop{8, up, 1})) << "past 3";
  calls.remove_at(8, all_calls);
  EXPECT_EQ(next_stop(calls, {.floor = 8, .direction = up}), (NextStop{3, none, 1}))
      << "low calls beyond the last standard one do not draw";
}

TEST(CollectiveControl, LowPriorityIsTakenAlongOnTheWay) {
  const LiftCalls calls = make({{car, standard, 6, 1}, {car, low, 4, 1}, {car, low, 9, 1}});
  EXPECT_EQ(next_stop(calls, {.floor = 2, .direction = up}).floor, 4);
  EXPECT_EQ(next_stop(calls, {.floor = 5, .direction = up}).floor, 6);
  EXPECT_EQ(next_stop(make({{car, low, 9, 1}}), {.floor = 5, .direction = up}).floor, 9)
      << "by itself where there is nothing else";
}

TEST(CollectiveControl, TheLanternShowsWhereTheCarGoesOn) {
  const LiftCalls calls = make({{hall_up, standard, 4, 1}, {car, standard, 2, 1}});
  EXPECT_EQ(departure(calls, {.floor = 4, .direction = up}), up);
  EXPECT_EQ(departure(calls, {.floor = 4, .direction = down}), down) << "2 is wanted in the car";
  EXPECT_EQ(departure(calls, {.floor = 2, .direction = down}), up);
  EXPECT_EQ(departure({}, {.floor = 2, .direction = down}), none);
}

/// A car without time: in each step it moves by a floor, or stands.
struct SteppedCar {
  LiftCalls calls;
  CollectiveCar state;

  /// What was answered.
  DoorMask step() {
    NextStop stop = next_stop(calls, state);
    if (stop.floor == 0) {
      state.direction = none;
      return 0;
    }
    if (stop.floor != state.floor) {
      state.direction = stop.floor > state.floor ? up : down;
      state.floor = static_cast<std::uint8_t>(state.floor + (state.direction == up ? 1 : -1));
      return 0;
    }
    RC_ASSERT(stop.doors != 0);
    state.direction = stop.departure;
    return calls.remove_at(stop.floor, answered_calls(stop.departure));
  }
};

Call random_call(Random& random, unsigned floors) {
  return {static_cast<CallKind>(random.below(4)), static_cast<CallPriority>(random.below(3)),
          static_cast<std::uint8_t>(1 + random.below(floors)),
          static_cast<DoorMask>(1U << random.below(4))};
}

RC_GTEST_PROP(CollectiveControl, NoCallIsLost, (std::uint64_t seed)) {
  Random random(seed);
  const unsigned floors = 2 + random.below(253);
  SteppedCar lift;
  lift.state.floor = static_cast<std::uint8_t>(1 + random.below(floors));
  const unsigned count = 1 + random.below(60);
  for (unsigned i = 0; i < count; ++i) lift.calls.add(random_call(random, floors));
  // Each sweep answers a level in one direction; there are three levels and two directions.
  const unsigned steps_max = 8 * floors + 4 * count;
  unsigned steps = 0;
  while (!lift.calls.empty()) {
    RC_ASSERT(steps++ < steps_max);
    (void)lift.step();
  }
}

RC_GTEST_PROP(CollectiveControl, NobodyInTheCarIsTakenBackWhileHisCallLiesAhead,
              (std::uint64_t seed)) {
  Random random(seed);
  const unsigned floors = 2 + random.below(40);
  SteppedCar lift;
  for (unsigned i = 0; i < 300; ++i) {
    if (random.below(4) == 0) {
      Call call = random_call(random, floors);
      call.priority = standard;
      lift.calls.add(call);
    }
    const std::uint8_t floor = lift.state.floor;
    const FloorSet wanted = lift.calls.floors(car_calls);
    const Direction before = lift.state.direction;
    (void)lift.step();
    if (lift.state.floor > floor && before == down) {
      RC_ASSERT(wanted.lowest() == 0 || wanted.lowest() >= floor);
    }
    if (lift.state.floor < floor && before == up) RC_ASSERT(wanted.highest() <= floor);
  }
}

RC_GTEST_PROP(CollectiveControl, EveryStopAnswersSomethingAndEveryAnswerIsDeterministic,
              (std::uint64_t seed)) {
  Random random(seed);
  LiftCalls calls;
  for (unsigned i = 0; i < random.below(12); ++i) calls.add(random_call(random, 20));
  const CollectiveCar state{.floor = static_cast<std::uint8_t>(1 + random.below(20)),
                            .direction = static_cast<Direction>(int(random.below(3)) - 1),
                            .takes_hall_calls = random.below(2) == 0};
  const NextStop stop = next_stop(calls, state);
  RC_ASSERT(stop == next_stop(calls, state));
  const CallKinds kinds = state.takes_hall_calls ? all_calls : car_calls;
  RC_ASSERT((stop.floor == 0) == calls.empty(kinds));
  RC_ASSERT((stop.doors == 0) == calls.empty(kinds));
}

}  // namespace
}  // namespace canvoy::cia417::collective_control_test
