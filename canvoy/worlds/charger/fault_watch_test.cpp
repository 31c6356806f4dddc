#include "canvoy/worlds/charger/fault_watch.hpp"

#include <gtest/gtest.h>

namespace canvoy::charger::fault_watch_test {
namespace {

using cia419::StopReason;

constexpr DetectionBounds promises{
    .heartbeat_time = 2s, .data_time = 600ms, .value_time = 300ms, .reaction_time = 100ms};

FaultPlan plan_of(FaultKind kind) {
  return {.seed = 1, .faults = {{kind, Time(1min)}}};
}

TEST(FaultWatchTest, AFaultThatHasNotBegunHasNothingToSay) {
  FaultWatch sut(plan_of(FaultKind::not_ready), promises);
  sut.note(Time(10s), StopReason::battery_not_ready);
  EXPECT_TRUE(sut.invariants().empty());
}

TEST(FaultWatchTest, AFaultIsSeenWhenTheChargerSaysSo) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(61s), StopReason::none);
  sut.note(Time(62s), StopReason::heartbeat_lost);
  sut.note(Time(70s), StopReason::none);
  const auto invariants = sut.invariants();
  ASSERT_EQ(invariants.size(), 1U);
  EXPECT_EQ(invariants[0].kind, InvariantKind::fault_seen);
  EXPECT_DOUBLE_EQ(invariants[0].worst, 2.0);
  EXPECT_DOUBLE_EQ(invariants[0].allowed, 2.1);
  EXPECT_TRUE(invariants[0].held);
  EXPECT_TRUE(invariants[0].is_decided());
  EXPECT_TRUE(sut.take_broken().empty());
}

TEST(FaultWatchTest, AFaultThatIsSeenTooLateIsBrokenOnce) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(62200ms), StopReason::none);
  const auto broken = sut.take_broken();
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_FALSE(broken[0].held);
  EXPECT_TRUE(broken[0].is_decided());
  EXPECT_TRUE(sut.take_broken().empty());
  sut.note(Time(63s), StopReason::heartbeat_lost);
  EXPECT_FALSE(sut.invariants()[0].held);
  EXPECT_DOUBLE_EQ(sut.invariants()[0].worst, 3.0);
}

TEST(FaultWatchTest, AValueThatCannotComeHasTheTimeOfWhatKeepsItBackAsWell) {
  for (const bool first : {true, false}) {
    FaultWatch sut(
        {.seed = 1,
         .faults = {{FaultKind::too_hot, Time(1min)}, {FaultKind::pdo_loss, Time(1min)}}},
        promises);
    sut.began(first ? 0 : 1, Time(1min), StopReason::none);
    sut.began(first ? 1 : 0, Time(1min), StopReason::none);
    EXPECT_DOUBLE_EQ(sut.invariants()[0].allowed, 0.4 + 0.7);
    EXPECT_DOUBLE_EQ(sut.invariants()[1].allowed, 0.7);
  }
}

TEST(FaultWatchTest, AFaultThatIsOverKeepsNothingBack) {
  FaultWatch sut(
      {.seed = 1, .faults = {{FaultKind::too_hot, Time(1min)}, {FaultKind::pdo_loss, Time(1min)}}},
      promises);
  sut.began(1, Time(1min), StopReason::none);
  sut.ended(1);
  sut.began(0, Time(61s), StopReason::none);
  EXPECT_DOUBLE_EQ(sut.invariants()[0].allowed, 0.4);
}

TEST(FaultWatchTest, ABootUpMessageThatCannotComeNeedNotBeSeen) {
  FaultWatch sut({.seed = 1,
                  .faults = {{FaultKind::battery_restart, Time(1min)},
                             {FaultKind::heartbeat_loss, Time(1min)}}},
                 promises);
  sut.began(1, Time(1min), StopReason::none);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(70s), StopReason::none);
  EXPECT_TRUE(sut.invariants()[0].held);
  EXPECT_FALSE(sut.invariants()[0].is_decided());
  EXPECT_FALSE(sut.invariants()[1].held) << "that one is to be seen";
}

TEST(FaultWatchTest, AStopForAnotherLesserReasonIsNoAnswer) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(65s), StopReason::battery_not_ready);
  EXPECT_FALSE(sut.invariants()[0].held);
}

TEST(FaultWatchTest, AFaultThatBeginsWhileTheChargerHasStoppedIsJudgedFromWhenItDelivers) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::too_hot);
  sut.note(Time(70s), StopReason::too_hot);
  EXPECT_TRUE(sut.invariants()[0].held);
  EXPECT_FALSE(sut.invariants()[0].is_decided());
  sut.note(Time(71s), StopReason::none);
  sut.note(Time(73100ms), StopReason::none);
  EXPECT_TRUE(sut.invariants()[0].held);
  sut.note(Time(73101ms), StopReason::none);
  EXPECT_FALSE(sut.invariants()[0].held);
}

TEST(FaultWatchTest, ARestartThatBeganWhileTheChargerHadStoppedIsNotWaitedFor) {
  FaultWatch sut(plan_of(FaultKind::battery_restart), promises);
  sut.began(0, Time(1min), StopReason::heartbeat_lost);
  sut.note(Time(2min), StopReason::none);
  sut.note(Time(3min), StopReason::none);
  EXPECT_TRUE(sut.invariants()[0].held);
  EXPECT_FALSE(sut.invariants()[0].is_decided());
}

TEST(FaultWatchTest, BesideASecondBatteryNothingIsExpectedOfTheFirst) {
  FaultPlan plan{
      .seed = 1,
      .faults = {{FaultKind::duplicate_node_id, Time(1min)}, {FaultKind::pdo_loss, Time(2min)}}};
  FaultWatch sut(plan, promises);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(1min) + 50ms, StopReason::no_battery);
  sut.began(1, Time(2min), StopReason::none);
  sut.note(Time(3min), StopReason::none);
  ASSERT_EQ(sut.invariants().size(), 2U);
  EXPECT_TRUE(sut.invariants()[0].is_decided());
  EXPECT_TRUE(sut.invariants()[1].held);
  EXPECT_FALSE(sut.invariants()[1].is_decided());
}

TEST(FaultWatchTest, AChargerThatHasStoppedForSomethingMoreSeriousNeedNotSayMore) {
  FaultWatch sut(plan_of(FaultKind::not_ready), promises);
  sut.began(0, Time(1min), StopReason::heartbeat_lost);
  EXPECT_TRUE(sut.invariants()[0].held);
  EXPECT_DOUBLE_EQ(sut.invariants()[0].worst, 0.0);
}

TEST(FaultWatchTest, AStoppedChargerThatSaysItAnewHasSeenIt) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::too_hot);
  sut.note(Time(62s), StopReason::heartbeat_lost);
  EXPECT_TRUE(sut.invariants()[0].is_decided());
  EXPECT_DOUBLE_EQ(sut.invariants()[0].worst, 2.0);
  FaultWatch late(plan_of(FaultKind::heartbeat_loss), promises);
  late.began(0, Time(1min), StopReason::too_hot);
  late.note(Time(63s), StopReason::heartbeat_lost);
  EXPECT_FALSE(late.invariants()[0].is_decided()) << "while it is stopped, none is required";
  EXPECT_TRUE(late.invariants()[0].held);
}

TEST(FaultWatchTest, AnAnswerThatWasThereBeforeTheFaultDecidesNothing) {
  const StopReason before[] = {StopReason::heartbeat_lost, StopReason::battery_data_missed,
                               StopReason::no_battery,     StopReason::no_pilot_signal,
                               StopReason::too_hot,        StopReason::battery_full};
  for (std::size_t kind = 0; kind < fault_kinds; ++kind) {
    for (const StopReason reason : before) {
      FaultWatch sut(plan_of(static_cast<FaultKind>(kind)), promises);
      sut.began(0, Time(1min), reason);
      sut.note(Time(2min), reason);
      for (const Invariant& invariant : sut.invariants()) {
        EXPECT_FALSE(invariant.is_decided()) << fault_rows[kind].name;
        EXPECT_TRUE(invariant.held) << fault_rows[kind].name;
      }
    }
  }
}

TEST(FaultWatchTest, AFaultThatIsOverBeforeThePromisedTimeDecidesNothing) {
  FaultWatch sut(plan_of(FaultKind::heartbeat_loss), promises);
  sut.began(0, Time(1min), StopReason::none);
  sut.note(Time(61s), StopReason::none);
  sut.ended(0);
  sut.note(Time(70s), StopReason::none);
  EXPECT_TRUE(sut.invariants()[0].held);
  EXPECT_FALSE(sut.invariants()[0].is_decided());
}

TEST(FaultWatchTest, EachKindIsAnsweredByItsOwnReasonWithinItsOwnTime) {
  struct Case {
    FaultKind kind;
    StopReason answer;
    Duration bound;
  };
  const Case cases[] = {
      {FaultKind::heartbeat_loss, StopReason::heartbeat_lost, 2100ms},
      {FaultKind::pdo_loss, StopReason::battery_data_missed, 700ms},
      {FaultKind::battery_silent, StopReason::heartbeat_lost, 700ms},
      {FaultKind::battery_silent, StopReason::battery_data_missed, 700ms},
      {FaultKind::battery_restart, StopReason::no_battery, 100ms},
      {FaultKind::not_ready, StopReason::battery_not_ready, 400ms},
      {FaultKind::not_ready, StopReason::battery_full, 400ms},
      {FaultKind::too_hot, StopReason::too_hot, 400ms},
      {FaultKind::too_cold, StopReason::too_cold, 400ms},
      {FaultKind::invalid_temperature, StopReason::invalid_temperature, 400ms},
      {FaultKind::invalid_voltage, StopReason::invalid_voltage, 400ms},
      {FaultKind::pilot_loss, StopReason::no_pilot_signal, 100ms},
      {FaultKind::cable_cut, StopReason::battery_data_missed, 700ms},
      {FaultKind::babbling_node, StopReason::heartbeat_lost, 700ms},
      {FaultKind::duplicate_node_id, StopReason::no_battery, 100ms},
      {FaultKind::wrong_bit_rate, StopReason::bus_off, 700ms},
  };
  for (const Case& expected : cases) {
    FaultWatch sut(plan_of(expected.kind), promises);
    sut.began(0, Time(1min), StopReason::none);
    sut.note(Time(1min) + expected.bound, expected.answer);
    const auto invariants = sut.invariants();
    ASSERT_EQ(invariants.size(), 1U);
    EXPECT_TRUE(invariants[0].held) << fault_name(expected.kind);
    EXPECT_TRUE(invariants[0].is_decided()) << fault_name(expected.kind);

    FaultWatch late(plan_of(expected.kind), promises);
    late.began(0, Time(1min), StopReason::none);
    late.note(Time(1min) + expected.bound + 1us, expected.answer);
    EXPECT_FALSE(late.invariants()[0].held) << fault_name(expected.kind);
  }
}

TEST(FaultWatchTest, WhatNeedNotStopAChargeIsNotWaitedFor) {
  for (const FaultKind kind : {FaultKind::corrupted_frames, FaultKind::clock_drift}) {
    FaultWatch sut(plan_of(kind), promises);
    sut.began(0, Time(1min), StopReason::none);
    sut.note(Time(1h), StopReason::none);
    EXPECT_TRUE(sut.invariants().empty());
    EXPECT_TRUE(sut.take_broken().empty());
  }
}

}  // namespace
}  // namespace canvoy::charger::fault_watch_test
