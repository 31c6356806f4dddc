#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::rpdo_deadline_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

TEST(Rpdo, ThatDoesNotComeInTimeIsAnErrorUntilItComes) {
  PdoNode node;
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1401, 5, 100), none);
  node.operate();
  node.run_until(Time(1s));
  EXPECT_TRUE(node.errors().empty()) << "supervision begins with the first reception";
  node.receive("205#01 00");
  node.run_until(Time(1100ms - 1us));
  EXPECT_TRUE(node.errors().empty());
  node.run_until(Time(1100ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/2"}));
  node.run_until(Time(2s));
  EXPECT_TRUE(node.errors().empty()) << "told once";
  node.receive("205#02 00");
  EXPECT_EQ(node.errors(), Texts({"-8250/2"}));
  EXPECT_EQ(node.number(0x2010, 1), 2U);
  node.run_until(Time(2100ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/2"}));
}

TEST(Rpdo, WithoutADeadlineLeavesTheNodeNothingToDo) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.node.receive(wire_frame("205#01 00"), node.now);
  EXPECT_EQ(node.number(0x2010, 1), 1U);
  EXPECT_EQ(node.node.deadline(), never);
}

TEST(Rpdo, ThatComesAgainAndAgainKeepsItsDeadlineAway) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  for (int i = 0; i < 20; ++i) {
    node.receive("205#01 00");
    node.run_for(99ms);
  }
  EXPECT_TRUE(node.errors().empty());
  node.run_for(1ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"})) << "100 ms after the last one";
}

TEST(Rpdo, TooShortDoesNotMeetTheDeadline) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.run_for(60ms);
  node.receive("205#01");
  EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
  node.run_for(40ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
  node.receive("205#01 00");
  EXPECT_EQ(node.errors(), Texts({"-8210/1", "-8250/1"}));
}

TEST(Rpdo, SynchronousMeetsItsDeadlineWhenItIsReceived) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.run_for(99ms);
  node.receive("205#01 00");
  node.run_for(99ms);
  EXPECT_TRUE(node.errors().empty());
  node.run_for(1ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, TimeOutsOfOneLeaveTheOthersAlone) {
  PdoNode node;
  for (unsigned pdo = 1; pdo <= 4; ++pdo) {
    node.map_rpdo(pdo, 0x200 + pdo, 255, {0x2000'01'08});
    ASSERT_EQ(node.write(static_cast<std::uint16_t>(0x13FF + pdo), 5, 100 * pdo), none);
  }
  node.operate();
  for (const char* frame : {"201#01", "202#01", "203#01", "204#01"}) node.receive(frame);
  node.run_until(Time(200ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1", "+8250/2"}));
  node.receive("201#01");
  EXPECT_EQ(node.errors(), Texts({"-8250/1"}));
  node.run_until(Time(400ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1", "+8250/3", "+8250/4"}));
}

TEST(Rpdo, DeadlineEndsWithOperationalAndBeginsAnewWithAReception) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.receive("000#80 00");
  node.run_for(1s);
  node.operate();
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
  node.receive("205#01 00");
  node.run_for(100ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, DeadlineCanBeChangedWhileThePdoIsValid) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 1000), none);
  node.operate();
  node.receive("205#01 00");
  node.run_until(Time(500ms));
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.run_until(Time(600ms - 1us));
  EXPECT_TRUE(node.errors().empty());
  node.run_until(Time(600ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
  ASSERT_EQ(node.write(0x1400, 5, 0), none);
  EXPECT_EQ(node.errors(), Texts({"-8250/1"})) << "without a deadline nothing is late";
}

TEST(Rpdo, ADeadlineThatIsSetLateSupervisesFromTheNextReception) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
  node.receive("205#03 00");
  node.run_for(100ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, MadeInvalidClearsItsErrorsAndItsDeadline) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01");
  node.receive("205#01 00 00");
  ASSERT_EQ(node.errors(), Texts({"+8210/1", "-8210/1", "+8220/1"}));
  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  EXPECT_EQ(node.errors(), Texts({"-8220/1"}));
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
}

TEST(Rpdo, TellsTheApplicationOfReceptionsAndTimeOuts) {
  PdoNode node;
  Texts told;
  auto received = [&](std::uint16_t number) {
    told.push_back("received " + std::to_string(number) + " with " +
                   std::to_string(node.number(0x2010, 1)));
  };
  auto timed_out = [&](std::uint16_t number) {
    told.push_back("timed out " + std::to_string(number));
  };
  node.rpdos.received = Callback<void(std::uint16_t)>::of(received);
  node.rpdos.timed_out = Callback<void(std::uint16_t)>::of(timed_out);
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1401, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  node.receive("205#03");
  node.run_for(100ms);
  EXPECT_EQ(told, Texts({"received 2 with 1", "received 2 with 2", "timed out 2"}));
}

}  // namespace
}  // namespace canvoy::rpdo_deadline_test
