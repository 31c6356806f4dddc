#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_inhibit_time_test {
namespace {

using enum AbortCode;

TEST(Tpdo, AnEventWithinTheInhibitTimeIsSentWhenItIsOverWithTheValuesOfThen) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(50ms));
  node.set(0x2010, 1, 1);
  node.expect({"@50000 185#01 00"});
  node.run_until(Time(52ms));
  node.set(0x2010, 1, 2);
  node.run_until(Time(59ms));
  node.set(0x2010, 1, 3);
  node.run_until(Time(60ms - 1us));
  node.expect({});
  node.run_until(Time(1s));
  node.expect({"@60000 185#03 00"});
  node.set(0x2010, 1, 4);
  node.expect({"@1000000 185#04 00"});
}

TEST(Tpdo, TheInhibitTimeBeginsAnewWithEachTransmission) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  for (unsigned ms = 0; ms < 45; ++ms) {
    node.run_until(Time(std::chrono::milliseconds(ms)));
    node.set(0x2010, 1, ms + 1);
  }
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@10000 185#0A 00", "@20000 185#14 00", "@30000 185#1E 00",
               "@40000 185#28 00", "@50000 185#2D 00"});
}

/// More values change at once than are kept one by one: each TPDO is looked at.
TEST(Tpdo, OfManyChangesWithinTheInhibitTimeIsSentOnceWhenItIsOver) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.operate();
  node.set(0x2000, 1, 1);
  node.set(0x2000, 1, 2);
  node.expect({"@0 185#01"});
  node.node.advance(node.now);
  for (std::uint8_t sub = 1; sub <= 16; ++sub) {
    ASSERT_TRUE(node.node.dictionary().set_number(0x2000, sub, 3));
  }
  node.settle();
  node.node.advance(node.now);
  node.expect({"@0 285#03"});
  node.run_until(Time(1s));
  node.expect({"@10000 185#03"});
}

TEST(Tpdo, AnEventWithinTheInhibitTimeIsSentThoughTheChangeWasTakenBack) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 2);
  node.set(0x2010, 1, 1);
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@10000 185#01 00"});
}

TEST(Tpdo, WithAnInhibitTimeAndNoEventTimerNothingIsSentOfItself) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.run_until(Time(5h));
  node.expect({"@0 185#01 00"});
  node.set(0x2010, 1, 2);
  node.expect({"@18000000000 185#02 00"});
}

TEST(Tpdo, TriggersWithinTheInhibitTimeAreOneFrame) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 65535), none);
  node.map_tpdo(1, 0x185, 254, {0x2010'01'10});
  node.operate();
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(node.tpdos.trigger(1));
  node.run_until(Time(100s));
  node.expect({"@0 185#00 00", "@6553500 185#00 00"});
}

TEST(Tpdo, AnEventThatWaitsIsForgottenWhenOperationalEnds) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 2);
  node.receive("000#80 00");
  node.run_until(Time(1s));
  node.expect({"185#01 00"});
  node.operate();
  node.run_until(Time(2s));
  node.expect({});
}

TEST(Tpdo, TheInhibitTimeBeginsAnewWithOperational) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.run_until(Time(1ms));
  node.set(0x2010, 1, 2);
  node.run_until(Time(2ms));
  node.receive("000#80 00");
  node.operate();
  node.run_until(Time(5ms));
  node.set(0x2010, 1, 3);
  node.run_until(Time(6ms));
  node.set(0x2010, 1, 4);
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@5000 185#03 00", "@15000 185#04 00"});
}

TEST(Tpdo, InhibitTimeAndSyncStartChangeOnlyWhileThePdoIsInvalid) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  EXPECT_EQ(node.write(0x1800, 3, 100), value_range);
  EXPECT_EQ(node.write(0x1800, 3, 0), none) << "no change";
  EXPECT_EQ(node.write(0x1800, 6, 1), value_range);
  EXPECT_EQ(node.write(0x1800, 6, 0), none) << "no change";
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(node.write(0x1800, 3, 100), none);
  for (unsigned value = 0; value <= 255; ++value) {
    EXPECT_EQ(node.write(0x1800, 6, value), value <= 240 ? none : value_range);
  }
}

TEST(Tpdo, KeepsTheInhibitTimeTowardsAnAnswerThatComesAtOnce) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(50ms));
  unsigned answers = 0;
  node.on_sent = [&](const Frame&) {
    if (++answers < 10) node.tpdos.trigger(1);
  };
  node.set(0x2010, 1, 1);
  node.expect({"@50000 185#01 00"});
  node.run_until(Time(65ms));
  node.expect({"@60000 185#01 00"});
}

TEST(Tpdo, IsNotInhibitedAnewWhereAnAnswerThatComesAtOnceBeganANewLife) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(50ms));
  node.on_sent = [&](const Frame&) {
    node.node.receive(wire_frame("000#80 00"), node.now);
    node.node.receive(wire_frame("000#01 00"), node.now);
  };
  node.set(0x2010, 1, 1);
  node.on_sent = [](const Frame&) {};
  node.set(0x2010, 1, 2);
  node.expect({"@50000 185#01 00", "@50000 185#02 00"});
}

}  // namespace
}  // namespace canvoy::tpdo_inhibit_time_test
