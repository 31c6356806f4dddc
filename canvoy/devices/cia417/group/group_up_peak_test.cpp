// More passengers at the main floor than one car takes: frames of the group's bus. First the test
// plays lifts 1 to 4, which stand at floor 1; then there are three real ones.
#include "canvoy/devices/cia417/group/group_test.hpp"

namespace canvoy::cia417::group_up_peak_test {
namespace {

class GroupUpPeakTest : public testing::Test {
 protected:
  GroupUpPeakTest() {
    cable.connect(0, device.node());
    cable.start_all();
    wait(0s);
    for (unsigned lift = 1; lift <= 4; ++lift) {
      tell(lift, "40 01", "00 F0 01");  // it is at floor 1,
      tell(lift, "43 0A", "00 F0 00");  // and not out of order
    }
    cable.clear();
  }
  static GroupControllerSettings settings() {
    GroupControllerSettings made{.lifts = 4, .up_peak = {.in_a_row = 1}};
    for (GroupLift& lift : made.lift) lift.served = {FloorSet::between(1, 10)};
    return made;
  }
  /// While all lifts are received.
  void wait(Duration duration) {
    const Time end = cable.now + duration;
    for (Time next = cable.now; next <= end; next += 500ms) {
      cable.run_until(next);
      for (const char* const heartbeat : {"701#05", "702#05", "703#05", "704#05"}) {
        cable.send(heartbeat);
      }
    }
    cable.run_until(end);
  }
  /// A record of a lift, without its mask.
  void tell(unsigned lift, const std::string& what, const std::string& where) {
    char text[48];
    std::snprintf(text, sizeof text, "40%X#%s %02X %s", lift, what.c_str(), 1U << (lift - 1),
                  where.c_str());
    cable.send(text);
  }
  void opens(unsigned lift) { tell(lift, "44 01", "01 10 01"); }
  void leaves(unsigned lift) {
    tell(lift, "05 06", "00 F1 01");
    tell(lift, "40 02", "00 F0 01");
    tell(lift, "42 11", "00 F0 01");
  }
  /// With closed doors, and no call.
  void rests(unsigned lift) { tell(lift, "42 00", "00 F0 01"); }
  void people_call() { cable.send("481#02 01 0F 01 10 01"); }
  /// A car has left, and passengers without room call at once.
  void leaves_people_behind(unsigned lift) {
    people_call();
    opens(lift);
    wait(10s);
    leaves(lift);
    wait(500ms);
    people_call();
  }
  /// Records of the group controller that assign calls, since the last time.
  std::vector<std::string> assigned() {
    std::vector<std::string> found;
    for (const auto& heard : cable.heard) {
      if (heard.frame.id == 0x491) found.push_back(wire_text(heard.frame));
    }
    cable.clear();
    return found;
  }
  using Frames = std::vector<std::string>;

  Cable cable;
  GroupControllerDevice<> device{cable.port(0), settings()};
};

TEST_F(GroupUpPeakTest, OneCarOpensForACall) {
  people_call();
  EXPECT_EQ(assigned(), Frames{"491#02 01 01 01 10 01"});
  opens(1);
  wait(10s);
  EXPECT_EQ(assigned(), Frames{});
}

TEST_F(GroupUpPeakTest, WhereACallComesAgainAsACarLeavesAnotherOpensBesideTheOneThatAnswers) {
  leaves_people_behind(1);
  EXPECT_EQ(assigned(), (Frames{"491#02 01 01 01 10 01", "491#02 01 02 01 10 01"}));
  opens(2);
  EXPECT_EQ(cable.last(0x400), "400#02 01 FF 01 10 00") << "the call is done";
  EXPECT_EQ(assigned(), Frames{"491#03 01 04 01 10 01"}) << "and lift 3 opens, too";
  opens(3);
  wait(10s);
  EXPECT_EQ(assigned(), Frames{}) << "two at a time";
  EXPECT_NE(cable.last(0x400).substr(0, 6), "400#03") << "no panel shows a call that nobody made";
}

TEST(GroupUpPeak, ByDefaultTwoCarsHaveToLeavePeopleBehindOneAfterTheOther) {
  EXPECT_EQ(GroupControllerSettings{}.up_peak.in_a_row, 2U);
  EXPECT_EQ(GroupControllerSettings{}.up_peak.cars_max, 2U);
}

TEST_F(GroupUpPeakTest, ACallLaterIsOfSomebodyElseAndBringsOneCar) {
  people_call();
  opens(1);
  wait(10s);
  leaves(1);
  wait(2s + Duration(1));
  people_call();
  assigned();
  opens(2);
  EXPECT_EQ(assigned(), Frames{});
}

TEST_F(GroupUpPeakTest, TheNextOneOpensAsSoonAsOneOfTheTwoHasLeft) {
  leaves_people_behind(1);
  opens(2);
  opens(3);
  assigned();
  leaves(2);
  EXPECT_EQ(assigned(), Frames{"491#03 01 08 01 10 01"});
}

TEST_F(GroupUpPeakTest, ACarThatComesWhileAnotherFillsOpens) {
  tell(3, "40 07", "00 F0 01");
  tell(4, "40 05", "00 F0 01");
  leaves_people_behind(1);
  opens(2);
  assigned();
  tell(4, "42 12", "00 F0 01");  // comes down
  tell(4, "40 01", "00 F0 01");
  EXPECT_EQ(assigned(), Frames{}) << "it has not arrived";
  rests(4);
  EXPECT_EQ(assigned(), Frames{"491#03 01 08 01 10 01"});
}

TEST_F(GroupUpPeakTest, ACarThatOpenedForNobodyIsNotAskedAgainUntilPeopleAreLeftBehindAgain) {
  leaves_people_behind(1);
  opens(2);
  opens(3);
  rests(3);
  EXPECT_EQ(assigned().back(), "491#03 01 08 01 10 01") << "lift 4 may still be needed";
  opens(4);
  rests(4);
  leaves(2);
  EXPECT_EQ(assigned(), Frames{});
  people_call();
  opens(3);
  EXPECT_EQ(assigned(), (Frames{"491#02 01 04 01 10 01", "491#03 01 08 01 10 01"}));
}

TEST_F(GroupUpPeakTest, WhatHasSomethingElseToDoIsNotAskedNorWhatDoesNotServe) {
  cable.send("481#02 01 04 05 10 01");  // a call that lift 3 alone may answer
  tell(4, "43 0A", "00 F0 01");         // out of order
  leaves_people_behind(1);
  opens(2);
  EXPECT_EQ(assigned().back(), "491#02 01 02 01 10 01");
}

TEST_F(GroupUpPeakTest, CallsElsewhereAndDownwardsDoNotCount) {
  for (const char* const call : {"481#02 01 0F 02 10 01", "481#02 02 0F 02 10 01"}) {
    people_call();
    opens(1);
    leaves(1);
    assigned();
    cable.send(call);
    opens(2);
    EXPECT_EQ(assigned().size(), 1U) << call;
    tell(1, "40 01", "00 F0 01");
    rests(1);
    rests(2);
  }
}

TEST_F(GroupTest, TwoCarsFillAtTheMainFloorWhenOneHasLeftPeopleBehind) {
  press(1, "02 01 07 01 10 01");
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 1); }));
  press(1, "05 06 01 00 11 01");
  ASSERT_TRUE(run_until([&] { return benches[0].lift.is_moving(); }));
  press(2, "02 01 07 01 10 01");
  EXPECT_TRUE(run_until([&] { return is_open_at(2, 1) && is_open_at(3, 1); }, 3s));
  EXPECT_EQ(count("403#44 01 04 01 10 01"), 1U) << "lift 3 says that it opens, and goes up";
  for (LiftBench& bench : benches) {
    EXPECT_TRUE(bench.device.calls().calls().empty(hall_calls)) << "all are answered";
    EXPECT_EQ(bench.told("400#03 01 01 01 10 81"), 0U);
  }
  press(1, "02 02 07 07 10 01");
  EXPECT_TRUE(run_until([&] { return is_open_at(1, 7) || is_open_at(2, 7) || is_open_at(3, 7); }))
      << "others are answered as before";
}

TEST_F(GroupTest, ACarThatGetsACallOfItsOwnFirstAnswersThatAndThenComes) {
  press(1, "02 01 07 01 10 01");
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 1); }));
  press(1, "05 06 01 00 11 01");
  ASSERT_TRUE(run_until([&] { return benches[0].lift.is_moving(); }));
  press(3, "05 03 04 00 11 01");
  bus.send("491#03 01 04 01 10 01");
  EXPECT_TRUE(run_until([&] { return is_open_at(3, 3); })) << "it is of low priority";
  EXPECT_TRUE(run_until([&] { return is_open_at(3, 1); }));
}

}  // namespace
}  // namespace canvoy::cia417::group_up_peak_test
