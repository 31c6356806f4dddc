#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::rpdo_synchronous_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

TEST(Rpdo, OfTypes0To240IsTakenOverAtTheNextSyncAndOf254And255AtOnce) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 254) continue;
    PdoNode node;
    node.map_rpdo(1, 0x205, type, {0x2010'01'10});
    node.operate();
    node.receive("205#01 02");
    EXPECT_EQ(node.number(0x2010, 1), type <= 240 ? 0U : 0x0201U) << type;
    node.receive("080#");
    EXPECT_EQ(node.number(0x2010, 1), 0x0201U) << type;
  }
}

TEST(Rpdo, SynchronousTakesTheLastValuesOnceAndTheOldOnesNeverAgain) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
  node.set(0x2010, 1, 7);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 7U);
}

TEST(Rpdo, SynchronousForgetsWhatItHoldsWhenTheNodeLeavesOperational) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("000#80 00");
  node.operate();
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
}

TEST(Rpdo, ThatBecomesEventDrivenForgetsWhatItHolds) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  ASSERT_EQ(node.write(0x1400, 2, 255), none);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
  node.receive("205#02 00");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
}

TEST(Rpdo, ThatBecomesSynchronousWaitsForSync) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  for (int i = 0; i < 3; ++i) node.receive("205#01 00");
  ASSERT_EQ(node.write(0x1400, 2, 1), none);
  node.receive("205#02 00");
  EXPECT_EQ(node.number(0x2010, 1), 1U);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
}

TEST(Rpdo, SynchronousComesTooLateBehindTheSynchronousWindow) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1007, 0, 2000), none);
  node.operate();
  node.run_until(Time(10ms));
  node.receive("080#");
  node.run_until(Time(12ms));
  node.receive("205#01 00");
  node.run_until(Time(12ms + 1us));
  node.receive("205#02 00");
  node.run_until(Time(20ms));
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 1U);
}

TEST(Rpdo, SynchronousComesInTimeWhereNoSyncHasOpenedAWindowYet) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1007, 0, 2000), none);
  node.operate();
  node.run_until(Time(1s));
  node.receive("205#01 00");
  node.run_until(Time(2s));
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 1U);
}

/// PDOs that came in NMT state stopped were not received.
TEST(Rpdo, SynchronousComesInTimeBeforeTheFirstSyncAfterAReset) {
  for (const char* until : {"000#82 00", "000#02 00"}) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
    ASSERT_EQ(node.write(0x1007, 0, 2000), none);
    node.operate();
    node.receive("080#");
    node.receive(until);
    node.run_until(Time(1s));
    if (node.number(0x1007, 0) == 0) {
      node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
      ASSERT_EQ(node.write(0x1007, 0, 2000), none);
    }
    node.operate();
    node.receive("205#01 00");
    node.receive("080#");
    EXPECT_EQ(node.number(0x2010, 1), 1U) << until;
    node.run_until(Time(1s + 2ms + 1us));
    node.receive("205#02 00");
    node.receive("080#");
    EXPECT_EQ(node.number(0x2010, 1), 1U) << "the window is over";
  }
}

TEST(Rpdo, SynchronousIsCheckedWhenItIsTakenOver) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10, 0x2060'00'08});
  node.operate();
  node.receive("205#01 00 63");
  EXPECT_TRUE(node.errors().empty());
  node.receive("080#");
  EXPECT_EQ(node.errors(), Texts({"+8200/1"}));
  EXPECT_EQ(node.number(0x2010, 1), 0U);
}

TEST(Rpdo, SynchronousTellsTheApplicationAtSync) {
  PdoNode node;
  int told = 0;
  auto received = [&](std::uint16_t) { ++told; };
  node.rpdos.received = Callback<void(std::uint16_t)>::of(received);
  node.map_rpdo(1, 0x205, 5, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  EXPECT_EQ(told, 0);
  node.receive("080#");
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace canvoy::rpdo_synchronous_test
