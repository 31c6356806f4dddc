#include "canvoy/devices/cia417/lift/lift_calls.hpp"

#include <gtest/gtest.h>

namespace canvoy::cia417::lift_calls_test {
namespace {

TEST(LiftCalls, ACallIsThereUntilItIsAnswered) {
  LiftCalls calls;
  EXPECT_TRUE(calls.empty());
  EXPECT_TRUE(calls.add({.floor = 7}));
  EXPECT_FALSE(calls.add({.floor = 7})) << "it is there already";
  EXPECT_TRUE(calls.contains({.floor = 7}));
  EXPECT_EQ(calls.remove({.floor = 7}), 0b0001);
  EXPECT_EQ(calls.remove({.floor = 7}), 0);
  EXPECT_TRUE(calls.empty());
}

TEST(LiftCalls, NoFloorAndNoDoorIsNoCall) {
  LiftCalls calls;
  EXPECT_FALSE(calls.add({.floor = 0}));
  EXPECT_FALSE(calls.add({.floor = 255}));
  EXPECT_FALSE(calls.add({.floor = 3, .doors = 0}));
  EXPECT_FALSE(calls.add({.floor = 3, .doors = 0b1'0000})) << "a car has four doors";
  EXPECT_TRUE(calls.empty());
  EXPECT_TRUE(calls.add({.floor = 1}));
  EXPECT_TRUE(calls.add({.floor = 254}));
}

TEST(LiftCalls, ADoorMoreIsACallMore) {
  LiftCalls calls;
  EXPECT_TRUE(calls.add({.floor = 3, .doors = 0b0001}));
  EXPECT_TRUE(calls.add({.floor = 3, .doors = 0b0101}));
  EXPECT_FALSE(calls.add({.floor = 3, .doors = 0b0100}));
  EXPECT_EQ(calls.doors_at(3, car_calls), 0b0101);
  EXPECT_EQ(calls.remove({.floor = 3, .doors = 0b0011}), 0b0001) << "door 2 was not wanted";
  EXPECT_EQ(calls.doors_at(3, all_calls), 0b0100);
}

TEST(LiftCalls, KindsAndPrioritiesAreApart) {
  for (unsigned kind = 0; kind < call_kind_count; ++kind) {
    for (unsigned priority = 0; priority < call_priority_count; ++priority) {
      LiftCalls calls;
      const Call call{static_cast<CallKind>(kind), static_cast<CallPriority>(priority), 9, 0b10};
      calls.add(call);
      for (unsigned k = 0; k < call_kind_count; ++k) {
        const auto kinds = kinds_of(static_cast<CallKind>(k));
        EXPECT_EQ(calls.doors_at(9, kinds), k == kind ? 0b10 : 0);
        EXPECT_EQ(calls.empty(kinds), k != kind);
        for (unsigned p = 0; p < call_priority_count; ++p) {
          const auto level = static_cast<CallPriority>(p);
          EXPECT_EQ(calls.floors(kinds, level).contains(9), k == kind && p == priority);
          EXPECT_EQ(calls.contains({static_cast<CallKind>(k), level, 9, 0b10}),
                    k == kind && p == priority);
        }
      }
    }
  }
}

TEST(LiftCalls, AStopAnswersAllPrioritiesOfItsKinds) {
  LiftCalls calls;
  calls.add({CallKind::up, CallPriority::low, 4, 0b01});
  calls.add({CallKind::up, CallPriority::high, 4, 0b10});
  calls.add({CallKind::down, CallPriority::standard, 4, 0b01});
  calls.add({CallKind::car, CallPriority::standard, 5, 0b01});
  EXPECT_EQ(calls.remove_at(4, calls_up), 0b11);
  EXPECT_EQ(calls.doors_at(4, all_calls), 0b01) << "who wants down still waits";
  EXPECT_EQ(calls.floors(all_calls), FloorSet::between(4, 5));
  calls.remove_all(car_calls);
  EXPECT_EQ(calls.floors(all_calls), FloorSet::between(4, 4));
  calls.remove_all();
  EXPECT_TRUE(calls.empty());
}

TEST(LiftCalls, WhatTwoDoNotShareIsFoundOneByOne) {
  LiftCalls calls;
  LiftCalls told;
  EXPECT_EQ(calls.first_difference(told).floor, 0);
  calls.add({CallKind::down, CallPriority::low, 200, 0b1100});
  told.add({CallKind::car, CallPriority::high, 3, 0b0001});
  for (unsigned count = 0; count < 3; ++count) {
    const Call found = calls.first_difference(told);
    ASSERT_NE(found.floor, 0);
    ASSERT_NE(calls.contains(found), told.contains(found));
    if (calls.contains(found)) {
      told.add(found);
    } else {
      told.remove(found);
    }
  }
  EXPECT_EQ(calls.first_difference(told).floor, 0);
  EXPECT_EQ(told.doors_at(200, kinds_of(CallKind::down)), 0b1100);
}

TEST(LiftCalls, LowCallsBecomeStandardOnes) {
  LiftCalls calls;
  calls.add({CallKind::any, CallPriority::low, 4, 0b01});
  calls.add({CallKind::car, CallPriority::high, 5, 0b01});
  calls.promote_low();
  EXPECT_TRUE(calls.contains({CallKind::any, CallPriority::standard, 4, 0b01}));
  EXPECT_FALSE(calls.contains({CallKind::any, CallPriority::low, 4, 0b01}));
  EXPECT_TRUE(calls.contains({CallKind::car, CallPriority::high, 5, 0b01}));
}

}  // namespace
}  // namespace canvoy::cia417::lift_calls_test
