#include "canvoy/worlds/lift/fault_referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "canvoy/worlds/lift/fault.hpp"

namespace canvoy::lift::fault_referee_test {
namespace {

struct FaultRefereeTest : testing::Test {
  FaultRefereeTest() {
    sut.began(Time(10s), 3,
              {.lift = 2,
               .stands_within = 4s,
               .noticed_within = 500ms,
               .emergencies = {0x8130, 0x7300},
               .told_within = 2s,
               .serves_within = 30s});
  }
  void pass(Time from, Time until) {
    for (; from < until; from += 1s) sut.passed(from, 1s, [this](LiftNumber) { return is_wanted; });
  }
  Invariant get(InvariantKind kind, Time now) const {
    const std::vector<Invariant> all = sut.invariants(now);
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Invariant& one) { return one.kind == kind; });
    if (found == all.end()) return {.held = false};
    EXPECT_EQ(found->fault, 3U);
    EXPECT_EQ(found->part, 2);
    return *found;
  }
  FaultReferee sut;
  bool is_wanted = true;
};

TEST_F(FaultRefereeTest, ACarThatStandsInTimeIsSafe) {
  sut.stands(Time(12s), 1);  // another lift
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(13s)).is_decided());
  sut.stands(Time(13s), 2);
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).held);
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).is_decided());
  EXPECT_DOUBLE_EQ(get(InvariantKind::safe_stand, Time(60s)).worst, 3);
}

TEST_F(FaultRefereeTest, ACarThatDoesNotStandInTimeIsNot) {
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(14s)).held);
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(14'001ms)).held);
}

TEST_F(FaultRefereeTest, WhoBeganToWaitInAFaultOrJustAfterGivesUpBecauseOfIt) {
  EXPECT_TRUE(sut.excuses_waiting(Time(5s))) << "it came while he waited";
  sut.ended(Time(20s), 3);
  EXPECT_TRUE(sut.excuses_waiting(Time(5s)));
  EXPECT_TRUE(sut.excuses_waiting(Time(15s)));
  EXPECT_TRUE(sut.excuses_waiting(Time(49'999ms))) << "30 s are allowed until it serves again";
  EXPECT_FALSE(sut.excuses_waiting(Time(50s)));
  FaultReferee harmless;
  harmless.began(Time(10s), 0, {.lift = 2, .serves_within = 30s, .hinders_for = 1s});
  EXPECT_FALSE(harmless.excuses_waiting(Time(11s))) << "it hinders nobody for long";
  EXPECT_FALSE(FaultReferee().excuses_waiting(Time(0s)));
}

TEST_F(FaultRefereeTest, ACarThatStandsMustNotStartBeforeTheFaultHasGone) {
  sut.stands(Time(10s), 2);
  sut.starts(Time(10'500ms), 2);  // it may not have been noticed yet
  sut.stands(Time(12s), 2);
  sut.starts(Time(13s), 1);  // another lift
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).held);
  sut.starts(Time(30s), 2);
  sut.stands(Time(32s), 2);
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(60s)).held);
  EXPECT_DOUBLE_EQ(get(InvariantKind::safe_stand, Time(60s)).worst, 20);
  EXPECT_DOUBLE_EQ(get(InvariantKind::safe_stand, Time(60s)).allowed, 0.5);
}

TEST_F(FaultRefereeTest, WhatShowsLaterIsNoticedWhenItIsTold) {
  sut = {};
  sut.began(Time(10s), 3,
            {.lift = 2,
             .stands_within = 4s,
             .noticed_within = 500ms,
             .noticed_when_told = true,
             .emergencies = {0xFF06}});
  sut.stands(Time(10s), 2);
  sut.starts(Time(30s), 2);
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).held);
  sut.emergency_seen(Time(31s), 2, 0xFF06);
  sut.starts(Time(32s), 2);
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(60s)).held);
}

TEST_F(FaultRefereeTest, ACarThatStartsWhenTheFaultHasGoneIsSafe) {
  sut.stands(Time(10s), 2);
  sut.ended(Time(20s), 3);
  sut.starts(Time(20s), 2);
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).held);
}

TEST_F(FaultRefereeTest, AFaultThatWasOverBeforeCannotBeJudged) {
  sut.ended(Time(13s), 3);
  EXPECT_TRUE(get(InvariantKind::safe_stand, Time(60s)).held);
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(60s)).is_decided());
}

TEST_F(FaultRefereeTest, WhatAFaultHasLeftShowsOnceATechnicianHasGone) {
  sut.ended(Time(20s), 3);
  EXPECT_TRUE(sut.is_faulty(Time(20s) + 179s, 2));
  EXPECT_FALSE(sut.is_faulty(Time(20s) + 180s, 2));
  sut.handed_back(Time(5min), 1);  // another lift
  EXPECT_FALSE(sut.is_faulty(Time(5min), 2));
  sut.handed_back(Time(5min), 2);
  EXPECT_TRUE(sut.is_faulty(Time(5min) + 179s, 2));
  EXPECT_FALSE(sut.is_faulty(Time(5min) + 180s, 2));
  sut.starts(Time(5min) + 1s, 2);
  sut.serves(Time(5min) + 30s, 2);
  EXPECT_FALSE(sut.is_faulty(Time(5min) + 30s, 2)) << "it serves again";
}

TEST_F(FaultRefereeTest, ACarThatStoodBeforeHasToStayForWhatItCouldHaveDone) {
  FaultReferee stood;
  stood.stands(Time(9s), 2);
  stood.began(Time(10s), 0, {.lift = 2, .stands_within = 4s, .noticed_within = 500ms});
  stood.stands(Time(10s), 2);
  const auto is_decided = [&stood](Time now) { return stood.invariants(now)[0].is_decided(); };
  EXPECT_FALSE(is_decided(Time(10'500ms))) << "it may still start";
  EXPECT_TRUE(is_decided(Time(10'501ms)));
  stood.ended(Time(10'400ms), 0);
  EXPECT_FALSE(is_decided(Time(1min)));
  FaultReferee moved;
  moved.starts(Time(9s), 2);
  moved.began(Time(10s), 0, {.lift = 2, .stands_within = 4s, .noticed_within = 500ms});
  moved.stands(Time(10'100ms), 2);
  moved.ended(Time(10'400ms), 0);
  EXPECT_TRUE(moved.invariants(Time(1min))[0].is_decided()) << "it has stopped";
}

TEST_F(FaultRefereeTest, OneOfTheRightEmergenciesHasToBeHeard) {
  sut.emergency_seen(Time(11s), 2, 0x5000);  // another one
  sut.emergency_seen(Time(11s), 1, 0x7300);  // of another lift
  EXPECT_FALSE(get(InvariantKind::emergency_told, Time(12'001ms)).held);
  sut.emergency_seen(Time(11'500ms), 2, 0x7300);
  EXPECT_TRUE(get(InvariantKind::emergency_told, Time(60s)).held);
}

TEST_F(FaultRefereeTest, ServiceResumesWhenTheFirstIsCarriedAfterTheFault) {
  sut.serves(Time(15s), 2);  // it has not gone yet
  pass(Time(10s), Time(20s));
  sut.ended(Time(20s), 3);
  EXPECT_TRUE(sut.is_hindered(Time(20s), 2));
  EXPECT_FALSE(sut.is_hindered(Time(20s), 1));
  sut.starts(Time(22s), 2);
  pass(Time(20s), Time(45s));
  EXPECT_FALSE(get(InvariantKind::service_resumed, Time(45s)).is_decided());
  sut.serves(Time(45s), 2);
  pass(Time(45s), Time(90s));
  EXPECT_TRUE(get(InvariantKind::service_resumed, Time(90s)).held);
  EXPECT_TRUE(get(InvariantKind::service_resumed, Time(90s)).is_decided());
  EXPECT_DOUBLE_EQ(get(InvariantKind::service_resumed, Time(90s)).worst, 25);
  EXPECT_FALSE(sut.is_hindered(Time(51s), 2));
}

TEST_F(FaultRefereeTest, WhoLeavesACarThatHasNotMovedSinceWasNotCarried) {
  sut.stands(Time(12s), 2);
  sut.ended(Time(20s), 3);
  sut.starts(Time(20s), 1);  // another lift
  sut.serves(Time(21s), 2);
  EXPECT_TRUE(sut.is_hindered(Time(22s), 2));
  sut.starts(Time(23s), 2);
  sut.serves(Time(29s), 2);
  EXPECT_FALSE(sut.is_hindered(Time(30s), 2));
}

TEST_F(FaultRefereeTest, ACarThatMovedWhenTheFaultEndedCarries) {
  sut.starts(Time(10'100ms), 2);
  sut.ended(Time(20s), 3);
  sut.serves(Time(21s), 2);
  EXPECT_FALSE(sut.is_hindered(Time(22s), 2));
}

TEST_F(FaultRefereeTest, ALiftThatCarriesNobodyWhoWantsItDoesNotServe) {
  sut.ended(Time(20s), 3);
  pass(Time(20s), Time(50s));
  EXPECT_TRUE(get(InvariantKind::service_resumed, Time(50s)).held);
  pass(Time(50s), Time(51s));
  EXPECT_FALSE(get(InvariantKind::service_resumed, Time(51s)).held);
}

TEST_F(FaultRefereeTest, WhereNobodyWantsItNothingCanBeSaid) {
  sut.ended(Time(20s), 3);
  is_wanted = false;
  pass(Time(20s), Time(10min));
  EXPECT_TRUE(get(InvariantKind::service_resumed, Time(10min)).held);
  EXPECT_FALSE(get(InvariantKind::service_resumed, Time(10min)).is_decided());
  EXPECT_TRUE(sut.is_hindered(Time(199s), 2));
  EXPECT_FALSE(sut.is_hindered(Time(200s), 2)) << "no excuse for ever";
}

TEST_F(FaultRefereeTest, WhileAnotherFaultIsThereTheTimeDoesNotRun) {
  sut.began(Time(11s), 4, {.lift = 2});
  pass(Time(11s), Time(41s));
  sut.ended(Time(41s), 4);
  EXPECT_TRUE(get(InvariantKind::emergency_told, Time(42s)).held);
  EXPECT_FALSE(get(InvariantKind::emergency_told, Time(43s)).held) << "2 s alone";
  sut.ended(Time(50s), 3);
  sut.began(Time(60s), 5, {.lift = 2});
  pass(Time(50s), Time(60s));
  pass(Time(60s), Time(10min));
  EXPECT_TRUE(get(InvariantKind::service_resumed, Time(10min)).held);
  EXPECT_FALSE(get(InvariantKind::safe_stand, Time(10min)).held) << "to stand is asked always";
}

TEST_F(FaultRefereeTest, AFaultOfAGroupHindersForAWhileWhenItBeginsAndWhenItEnds) {
  sut.began(Time(100s), 4, {.lift = 0, .hinders_for = 10s});
  EXPECT_TRUE(sut.is_hindered(Time(109'999ms), 0));
  EXPECT_FALSE(sut.is_hindered(Time(110s), 0)) << "each lift serves alone";
  sut.ended(Time(130s), 4);
  EXPECT_TRUE(sut.is_hindered(Time(139s), 0));
  EXPECT_FALSE(sut.is_hindered(Time(140s), 0));
}

TEST_F(FaultRefereeTest, AGroupThatDoesNotServeAgainIsSeen) {
  sut = {};
  sut.began(Time(100s), 3, {.lift = 0, .serves_within = 10s, .hinders_for = 10s});
  sut.ended(Time(130s), 3);
  sut.serves(Time(131s), 2);  // a lift alone
  for (Time at(130s); at < Time(141s); at += 1s) {
    sut.passed(at, 1s, [](LiftNumber lift) { return lift == 0; });
  }
  const auto judged = [&] { return sut.invariants(Time(141s)).at(0); };
  EXPECT_EQ(judged().kind, InvariantKind::service_resumed);
  EXPECT_FALSE(judged().held);
}

TEST_F(FaultRefereeTest, AGroupCannotServeAgainWhileAnotherFaultOfItIsThere) {
  sut = {};
  const FaultExpectation of_group{.lift = 0, .serves_within = 10s, .hinders_for = 10s};
  sut.began(Time(100s), 3, of_group);
  sut.began(Time(100s), 4, of_group);
  sut.ended(Time(110s), 3);
  const auto is_wanted_group = [](LiftNumber lift) { return lift == 0; };
  const auto judged = [&](Time now) { return sut.invariants(now).at(0); };
  for (Time at(110s); at < Time(150s); at += 1s) sut.passed(at, 1s, is_wanted_group);
  EXPECT_TRUE(judged(Time(150s)).held) << "the other one is there";
  sut.ended(Time(150s), 4);
  // Each of them hinders for a while after its end.
  for (Time at(150s); at < Time(171s); at += 1s) sut.passed(at, 1s, is_wanted_group);
  EXPECT_FALSE(judged(Time(171s)).held);
}

TEST(RandomFaultsTest, TheyComeOneAtATimeInTheSpanAndByTheSeed) {
  const Building building = uniform_building({.lifts = 3});
  const auto faults = random_faults(building, Time(5min), Time(65min), 9);
  EXPECT_EQ(faults, random_faults(building, Time(5min), Time(65min), 9));
  EXPECT_NE(faults, random_faults(building, Time(5min), Time(65min), 10));
  ASSERT_GT(faults.size(), 5U);
  EXPECT_GE(faults.front().start, Time(5min));
  EXPECT_LE(faults.back().end(), Time(65min));
  for (std::size_t i = 1; i < faults.size(); ++i) {
    EXPECT_GT(faults[i].start, faults[i - 1].end());
    EXPECT_LE(faults[i].part, 3);
  }
}

/// A cut or a babbling node of the group is at its controller (0) or at one of its lifts.
TEST(RandomFaultsTest, OfAGroupMeetEachOfItsLiftsAndNoOther) {
  const Building building = uniform_building({.lifts = 3});
  std::array<unsigned, 4> met{};
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const ScheduledFault& fault : random_faults(building, Time(5min), Time(65min), seed)) {
      const bool has_place =
          fault.kind == FaultKind::cable_cut || fault.kind == FaultKind::babbling_node;
      if (fault.part != 0 || !has_place) continue;
      ASSERT_LE(fault.node, 3) << seed;
      ++met[fault.node];
    }
  }
  for (const unsigned times : met) EXPECT_GT(times, 0u);
}

}  // namespace
}  // namespace canvoy::lift::fault_referee_test
