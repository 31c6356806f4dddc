// A group of three lifts on a bus of its own, each with panels on its bus: frames of both.
#include "canvoy/devices/cia417/group/group_test.hpp"

namespace canvoy::cia417::group_test {
namespace {

TEST_F(GroupTest, LiftsTellWhereTheyAreAndThatTheyServe) {
  for (unsigned lift = 1; lift <= 3; ++lift) {
    EXPECT_TRUE(group.lift(lift).in_service);
    EXPECT_EQ(group.lift(lift).floor, 1);
  }
  send_to(2, 6);
  EXPECT_EQ(group.lift(2).floor, 6);
  EXPECT_EQ(count("402#40 06 02 00 F0 01"), 1u);
  EXPECT_EQ(count("402#05 06 02 00 F1 01") + count("402#05 06 02 00 F1 81"), 1u);
  EXPECT_TRUE(group.lift(2).car_calls.empty());
}

TEST_F(GroupTest, TheNearestLiftAnswersWhoeverPressed) {
  send_to(3, 8);
  bus.clear();
  press(1, "02 02 07 07 10 01");
  EXPECT_EQ(count("481#02 02 07 07 10 01"), 1u) << "from lift 1's panel to the group";
  EXPECT_EQ(count("491#02 02 04 07 10 01"), 1u) << "lift 3 has to answer it";
  EXPECT_EQ(count("400#02 02 FF 07 10 81"), 1u) << "and the panels light";
  for (unsigned lift = 1; lift <= 3; ++lift) {
    char shown[32];
    std::snprintf(shown, sizeof shown, "400#02 02 %02X 07 10 81", 1U << (lift - 1));
    EXPECT_EQ(benches[lift - 1].told(shown), 1u) << "on the bus of lift " << lift;
  }
  ASSERT_TRUE(run_until([&] { return is_open_at(3, 7); }));
  run_for(100ms);
  EXPECT_EQ(count("403#44 02 04 07 10 01"), 1u) << "it opens there, and goes on down";
  EXPECT_EQ(count("400#02 02 FF 07 10 00"), 1u) << "done";
  EXPECT_TRUE(group.hall_calls().calls().empty());
  EXPECT_EQ(benches[0].told("400#02 02 01 07 10 00"), 1u);
  EXPECT_TRUE(benches[0].at(1));
  EXPECT_TRUE(benches[1].at(1));
}

TEST_F(GroupTest, WhoPressesAgainIsAnsweredAgain) {
  press(1, "02 02 07 07 10 01");
  press(2, "02 02 07 07 10 01");
  EXPECT_EQ(count("400#02 02 FF 07 10 81"), 2u);
  EXPECT_EQ(group.hall_calls().calls().size(), 1u);
}

TEST_F(GroupTest, ALiftThatIsLostHandsItsCallsOver) {
  send_to(3, 8);
  press(1, "02 02 07 09 10 01");
  ASSERT_EQ(group.hall_calls().calls()[0].lift, 3);
  benches[2].car.is_stuck = true;
  bus.cut(3);
  run_for(2s);
  EXPECT_FALSE(group.lift(3).in_service);
  ASSERT_EQ(group.hall_calls().calls().size(), 1u);
  EXPECT_NE(group.hall_calls().calls()[0].lift, 3);
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 9) || is_open_at(2, 9); }));
  bus.cut(3, false);
  run_for(2s);
  EXPECT_TRUE(group.lift(3).in_service) << "back";
}

TEST_F(GroupTest, WhatALiftWasAskedForAloneItTellsTheGroupWhenItIsBack) {
  benches[2].car.is_stuck = true;
  bus.cut(3);
  run_for(2s);
  press(3, "02 01 07 04 10 01");
  EXPECT_TRUE(group.hall_calls().calls().empty());
  bus.cut(3, false);
  run_for(1s);
  EXPECT_EQ(count("483#02 01 FF 04 10 01"), 1u);
  ASSERT_EQ(group.hall_calls().calls().size(), 1u);
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 4) || is_open_at(2, 4); }));
  run_for(1s);
  EXPECT_EQ(benches[2].told("400#02 01 04 04 10 00"), 1u) << "its lamp goes out";
}

TEST_F(GroupTest, WhatALiftWasGivenWhileItDidNotHearItIsGivenAnew) {
  send_to(3, 8);
  bus.cut(3);
  run_for(100ms);
  press(1, "02 02 07 09 10 01");
  ASSERT_EQ(group.hall_calls().calls()[0].lift, 3);
  run_for(1100ms);
  bus.cut(3, false);
  EXPECT_TRUE(run_until([&] { return is_open_at(3, 9); }, 30s));
}

TEST_F(GroupTest, ALampThatTheGroupPutOutMeanwhileGoesOutInALiftThatComesBack) {
  press(3, "02 01 07 04 10 01");
  ASSERT_EQ(benches[2].told("400#02 01 04 04 10 81"), 1u);
  benches[2].car.is_stuck = true;
  bus.cut(3);
  ASSERT_TRUE(run_until([&] { return group.hall_calls().calls().empty(); }));
  EXPECT_EQ(benches[2].told("400#02 01 04 04 10 00"), 0u);
  bus.cut(3, false);
  // It was alone with this call, and sends it to the group again.
  ASSERT_TRUE(run_until([&] { return benches[2].told("400#02 01 04 04 10 00") == 1u; }));
}

TEST_F(GroupTest, ALiftOnAnotherServiceHandsItsCallsOver) {
  send_to(3, 8);
  press(1, "02 02 07 10 10 01");
  press(1, "02 02 07 09 10 01");
  ASSERT_EQ(group.hall_calls().calls()[0].lift, 3);
  press(3, "0E 0F 04 00 10 81");
  EXPECT_EQ(count("403#43 0A 04 00 F0 01"), 1u);
  EXPECT_NE(group.hall_calls().calls()[0].lift, 3);
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 9) || is_open_at(2, 9); }));
}

TEST_F(GroupTest, WithoutGroupControllerEachLiftServesItsPanels) {
  press(1, "02 02 07 07 10 01");
  bus.cut(0);
  run_for(2s);
  EXPECT_FALSE(members[0].member().is_in_group());
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 7) || is_open_at(2, 7) || is_open_at(3, 7); }))
      << "the call is not lost";
  press(2, "02 01 07 04 10 01");
  EXPECT_EQ(benches[1].told("400#02 01 02 04 10 81"), 1u);
  ASSERT_TRUE(run_until([&] { return is_open_at(2, 4); }));
  bus.cut(0, false);
  run_for(2s);
  EXPECT_TRUE(members[0].member().is_in_group());
  EXPECT_TRUE(group.lift(2).in_service);
}

TEST_F(GroupTest, APassengerIsToldWhichLiftTakesHimToHisFloor) {
  bus.clear();
  press(2, "08 09 07 01 11 01");
  EXPECT_EQ(count("482#08 09 07 01 11 01"), 1u);
  EXPECT_EQ(count("491#08 09 01 01 11 01"), 1u) << "lift 1";
  EXPECT_EQ(benches[1].told("400#08 09 01 01 11 81"), 1u) << "shown where he pressed";
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 9); }));
  EXPECT_EQ(benches[0].told("400#05 09 01 00 F1 81"), 1u) << "a car call in that car";
  EXPECT_TRUE(benches[1].at(1));
  EXPECT_TRUE(group.destinations().calls().empty());
}

TEST_F(GroupTest, ACallToADestinationFloorIsDispatchedAndAnsweredByItsOwnFunction) {
  send_to(3, 8);
  bus.clear();
  press(1, "0B 02 07 07 11 01");
  EXPECT_EQ(count("481#0B 02 07 07 11 01"), 1u);
  EXPECT_EQ(count("491#0B 02 04 07 11 01"), 1u) << "lift 3 is one floor above";
  EXPECT_EQ(benches[0].told("400#0B 02 04 07 11 81"), 1u) << "shown where it was made";
  ASSERT_TRUE(run_until([&] { return is_open_at(3, 2); }));
  EXPECT_TRUE(benches[0].at(1));
  EXPECT_TRUE(group.destinations().calls().empty());
  press(1, "0D 02 07 07 11 01");
  EXPECT_EQ(group.destinations().calls()[0].call.priority, CallPriority::high);
}

TEST_F(GroupTest, HallCallsAndDestinationCallsShareTheStopsOfALift) {
  send_to(1, 5);
  send_to(2, 3);
  send_to(3, 9);
  press(2, "08 06 02 02 11 01");
  ASSERT_EQ(group.destinations().calls()[0].lift, 2) << "by its mask: from 2 to 6";
  EXPECT_TRUE(group.destinations().route(2).stops_up.contains(6));
  EXPECT_TRUE(group.hall_calls().route(2).stops_up.contains(6)) << "one truth";
  press(3, "02 01 07 02 10 01");
  ASSERT_EQ(group.hall_calls().calls().size(), 1u);
  EXPECT_EQ(group.hall_calls().calls()[0].lift, 2) << "that lift stops there anyway";
  EXPECT_TRUE(group.destinations().route(2).stops_up.contains(2));
  ASSERT_TRUE(run_until([&] { return is_open_at(2, 2); }));
  run_for(100ms);
  EXPECT_TRUE(group.hall_calls().calls().empty());
  EXPECT_TRUE(group.destinations().calls().empty());
  ASSERT_EQ(group.destinations().riders().size(), 1u);
  ASSERT_TRUE(run_until([&] { return is_open_at(2, 6); }));
  run_for(100ms);
  EXPECT_TRUE(group.destinations().riders().empty());
}

TEST_F(GroupTest, WhoIsFetchedByOneLiftLeavesThoseOfAnotherTheirs) {
  press(2, "08 09 02 03 11 01");
  press(3, "08 09 04 03 11 01");
  ASSERT_EQ(group.destinations().calls().size(), 2u);
  benches[2].car.is_stuck = true;
  ASSERT_TRUE(run_until([&] { return is_open_at(2, 3); }));
  run_for(100ms);
  EXPECT_EQ(count("400#08 09 02 03 11 00"), 1u) << "those of lift 2";
  ASSERT_EQ(group.destinations().calls().size(), 1u);
  EXPECT_FALSE(benches[2].device.calls().calls().empty(hall_calls)) << "lift 3 still has to come";
}

TEST_F(GroupTest, ALiftThatIsLostHandsItsPassengersOver) {
  send_to(3, 8);
  press(1, "08 02 07 0A 11 01");
  ASSERT_EQ(group.destinations().calls()[0].lift, 3);
  press(3, "0E 0F 04 00 10 81");
  EXPECT_EQ(count("491#08 02 04 0A 11 00"), 1u) << "lift 3 is on another service, and has it not";
  EXPECT_TRUE(benches[2].device.calls().calls().empty(hall_calls));
  EXPECT_EQ(count("491#08 02 01 0A 11 01"), 1u);
  EXPECT_EQ(benches[0].told("400#08 02 01 0A 11 81"), 1u) << "lift 1 comes";
  ASSERT_TRUE(run_until([&] { return is_open_at(1, 10); }));
}

TEST_F(GroupTest, WhatNoLiftServesIsNotAffirmed) {
  press(1, "02 01 07 05 20 01");
  EXPECT_EQ(count("400#02 01 FF 05 20 81"), 1u) << "door 2 is there";
  press(1, "08 05 07 03 12 01");
  EXPECT_EQ(group.destinations().calls().size(), 1u);
  bus.send("481#02 01 07 03 20 01");
  EXPECT_EQ(count("400#02 01 FF 03 20 00"), 1u);
  bus.send("481#08 0B 07 03 11 01");
  EXPECT_EQ(count("400#08 0B 07 03 11 00"), 1u) << "there is no floor 11";
}

TEST(GroupNodeId, MembersWatchTheGroupControllerWithTheNodeIdThatTheyAreTold) {
  LiftBench bench;
  Cable bus;
  GroupControllerDevice<> controller(bus.port(0), group_settings(), 16);
  GroupMemberDevice<> member(bus.port(1), 1, bench.device.node(), bench.device.calls(), bench.lift,
                             16);
  bus.connect(0, controller.node());
  bus.connect(1, member.node());
  bench.start();
  bus.start_all();
  for (unsigned i = 0; i < 100; ++i) {
    bench.step();
    bus.run_until(bench.cable.now);
  }
  EXPECT_EQ(member.node().dictionary().number(0x1016, 1), 0x0010'03E8u);
  EXPECT_TRUE(member.member().is_in_group());
  bus.clear();
  bench.press("02 02 01 07 10 01");
  bench.step();
  bus.run_until(bench.cable.now);
  EXPECT_EQ(bus.last(0x491), "491#02 02 01 07 10 01") << "CAN-IDs stay as they are";
}

TEST_F(GroupTest, GarbageOnTheGroupBusDoesNothing) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    char text[48];
    std::snprintf(text, sizeof text, "%03X#%02X %02X %02X %02X %02X %02X", 0x481 + byte % 8, byte,
                  byte * 7 % 256, byte * 13 % 256, byte * 29 % 256, byte * 31 % 256,
                  byte * 3 % 256);
    bus.send(text);
    text[0] = '4';
    text[1] = byte % 2 == 0 ? '0' : '9';
    text[2] = '1';
    bus.send(text);
  }
  run_for(5s);
  for (LiftBench& bench : benches) {
    EXPECT_LE(bench.device.calls().calls().floors(all_calls).highest(), 10) << "the last floor";
  }
  press(1, "02 02 07 07 10 01");
  EXPECT_GE(count("400#02 02 FF 07 10 81"), 1u) << "it lives on";
}

TEST_F(GroupTest, ManyCallsAreAllAnswered) {
  for (unsigned floor = 2; floor <= 9; ++floor) {
    char record[32];
    std::snprintf(record, sizeof record, "02 %02X 07 %02X 10 01", 1 + floor % 3, floor);
    press(1 + floor % 3, record);
  }
  EXPECT_EQ(group.hall_calls().calls().size(), 8u);
  ASSERT_TRUE(run_until([&] { return group.hall_calls().calls().empty(); }, 300s));
  for (LiftBench& bench : benches) {
    EXPECT_TRUE(bench.device.calls().calls().empty(hall_calls));
    EXPECT_FALSE(bench.car.left_unlocked);
  }
}

/// Its own bus has no call any more; the calls assigned by the group are assigned again.
TEST_F(GroupTest, ACallOfALiftWhoseControllerIsResetIsAnsweredAllTheSame) {
  send_to(3, 8);
  press(1, "02 02 07 09 10 01");
  ASSERT_EQ(group.hall_calls().calls()[0].lift, 3);
  benches[2].cable.send("000#81 01");
  benches[2].cable.send("000#01 01");
  EXPECT_TRUE(run_until([&] { return is_open_at(1, 9) || is_open_at(2, 9) || is_open_at(3, 9); }));
}

TEST_F(GroupTest, ALiftWhoseControllerIsNotOperationalDoesNotServe) {
  benches[2].cable.send("000#80 01");
  run_for(2s);
  EXPECT_FALSE(group.lift(3).in_service);
  benches[2].cable.send("000#01 01");
  run_for(2s);
  EXPECT_TRUE(group.lift(3).in_service);
}

TEST_F(GroupTest, WhatHasChangedWhileALiftWasNotHeardIsToldWhenItIsBack) {
  benches[2].weighed.full = true;
  run_for(100ms);
  ASSERT_TRUE(group.lift(3).full);
  bus.cut(3);
  run_for(2s);
  benches[2].weighed.full = false;
  bus.cut(3, false);
  run_for(3s);
  EXPECT_FALSE(group.lift(3).full);
}

TEST_F(GroupTest, CarCallsThatWereAnsweredWhileTheGroupWasStoppedAreToldWhenItStarts) {
  press(3, "05 03 FF 00 11 01");
  run_for(100ms);
  ASSERT_FALSE(group.lift(3).car_calls.empty());
  bus.send("000#02 11");
  ASSERT_TRUE(run_until([&] { return is_open_at(3, 3); }));
  bus.send("000#01 11");
  run_for(3s);
  EXPECT_TRUE(group.lift(3).car_calls.empty());
}

}  // namespace
}  // namespace canvoy::cia417::group_test
