// A consumer that misses SYNC. CiA 301 does not cover it: see docs/decisions.md.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::sync_supervision_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

/// A consumer of a SYNC of 10 ms.
struct Consumer : PdoNode {
  Consumer() { EXPECT_EQ(write(0x1006, 0, 10'000), none); }
};

TEST(SyncSupervision, FindsSyncLostOneAndAHalfPeriodsAfterTheLastOne) {
  Consumer node;
  node.receive("080#");
  node.run_until(Time(15ms - 1us));
  EXPECT_FALSE(node.sync.is_lost());
  node.run_until(Time(15ms));
  EXPECT_TRUE(node.sync.is_lost());
  node.run_until(Time(1s));
  EXPECT_TRUE(node.sync.is_lost());
  node.receive("080#");
  EXPECT_FALSE(node.sync.is_lost());
  node.run_until(Time(1015ms - 1us));
  EXPECT_FALSE(node.sync.is_lost());
  node.run_until(Time(1015ms));
  EXPECT_TRUE(node.sync.is_lost());
}

TEST(SyncSupervision, IsContentWhileSyncComes) {
  Consumer node;
  int changes = 0;
  auto count = [&](bool) { ++changes; };
  node.sync.lost_changed = Callback<void(bool)>::of(count);
  for (int i = 0; i < 100; ++i) {
    node.receive("080#");
    node.run_for(15ms - 1us);
  }
  EXPECT_EQ(changes, 0);
}

TEST(SyncSupervision, BeginsWithTheFirstSync) {
  Consumer node;
  node.operate();
  node.run_until(Time(1s));
  EXPECT_FALSE(node.sync.is_lost());
}

TEST(SyncSupervision, IsOffWhereThePeriodIsZero) {
  PdoNode node;
  node.receive("080#");
  node.run_until(Time(100s));
  EXPECT_FALSE(node.sync.is_lost());
}

TEST(SyncSupervision, OfAProducerIsNone) {
  Consumer node;
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(1s));
  EXPECT_FALSE(node.sync.is_lost());
  EXPECT_EQ(node.sent.size(), 100U);
}

TEST(SyncSupervision, GoesOnWhereAProducerBecomesAConsumer) {
  Consumer node;
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(30ms));
  ASSERT_EQ(node.write(0x1005, 0, 0x80), none);
  node.run_until(Time(100ms));
  EXPECT_FALSE(node.sync.is_lost()) << "nobody else was heard yet";
  node.receive("080#");
  node.run_until(Time(115ms));
  EXPECT_TRUE(node.sync.is_lost());
}

TEST(SyncSupervision, TakesAWrongLengthForNoSync) {
  Consumer node;
  node.receive("080#");
  node.run_until(Time(10ms));
  node.receive("080#01");
  node.run_until(Time(15ms));
  EXPECT_TRUE(node.sync.is_lost());
  node.receive("080#01");
  EXPECT_TRUE(node.sync.is_lost());
}

TEST(SyncSupervision, EndsOutsideOfPreOperationalAndOperational) {
  for (const char* command : {"000#02 00", "000#81 00", "000#82 05"}) {
    Consumer node;
    node.receive("080#");
    node.run_until(Time(15ms));
    ASSERT_TRUE(node.sync.is_lost());
    node.receive(command);
    EXPECT_FALSE(node.sync.is_lost()) << command;
    node.run_until(Time(1s));
    EXPECT_FALSE(node.sync.is_lost()) << command;
  }
}

TEST(SyncSupervision, BeginsAnewWithAnotherPeriod) {
  Consumer node;
  node.receive("080#");
  node.run_until(Time(15ms));
  ASSERT_TRUE(node.sync.is_lost());
  ASSERT_EQ(node.write(0x1006, 0, 20'000), none);
  EXPECT_FALSE(node.sync.is_lost());
  node.run_until(Time(100ms));
  EXPECT_FALSE(node.sync.is_lost());
  node.receive("080#");
  node.run_until(Time(130ms - 1us));
  EXPECT_FALSE(node.sync.is_lost());
  node.run_until(Time(130ms));
  EXPECT_TRUE(node.sync.is_lost());
  ASSERT_EQ(node.write(0x1006, 0, 0), none);
  EXPECT_FALSE(node.sync.is_lost());
}

TEST(SyncSupervision, TellsTheApplicationWhichMayRaiseAnError) {
  Consumer node;
  Texts told;
  auto note = [&](bool is_lost) { told.emplace_back(is_lost ? "lost" : "back"); };
  node.sync.lost_changed = Callback<void(bool)>::of(note);
  node.receive("080#");
  node.run_until(Time(15ms));
  node.receive("080#");
  EXPECT_EQ(told, Texts({"lost", "back"}));
  EXPECT_EQ(node.errors(), Texts()) << "by itself it notifies nobody else";
  auto raise = [&](bool is_lost) {
    constexpr Error error{.code = 0x8100, .register_bits = error_register::communication};
    is_lost ? node.node.raise(error) : node.node.clear(error);
  };
  node.sync.lost_changed = Callback<void(bool)>::of(raise);
  node.run_until(Time(30ms));
  EXPECT_EQ(node.errors(), Texts({"+8100/0"}));
  node.receive("080#");
  EXPECT_EQ(node.errors(), Texts({"-8100/0"}));
}

TEST(SyncSupervision, HoldsWhatTheLongestPeriodIs) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1006, 0, 0xFFFF'FFFF), none);
  node.receive("080#");
  node.run_until(Time(1us * (0xFFFF'FFFFLL * 3 / 2)) - 1us);
  EXPECT_FALSE(node.sync.is_lost());
  node.run_for(1us);
  EXPECT_TRUE(node.sync.is_lost());
}

}  // namespace
}  // namespace canvoy::sync_supervision_test
