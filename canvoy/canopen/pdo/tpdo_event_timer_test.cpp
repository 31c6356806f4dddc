#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_event_timer_test {
namespace {

using enum AbortCode;

TEST(Tpdo, IsSentWhenTheEventTimerExpires) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 254, {0x2010'01'10});
  node.run_until(Time(1s));
  node.expect({});
  node.operate();
  node.run_until(Time(1350ms));
  node.expect({"@1100000 185#00 00", "@1200000 185#00 00", "@1300000 185#00 00"});
  node.receive("000#80 00");
  node.run_until(Time(2s));
  node.expect({});
}

TEST(Tpdo, TheEventTimerBeginsAnewWithEachTransmission) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(70ms));
  node.set(0x2010, 1, 1);
  node.run_until(Time(300ms));
  node.expect({"@70000 185#01 00", "@170000 185#01 00", "@270000 185#01 00"});
}

TEST(Tpdo, TheEventTimerKeepsTheInhibitTime) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 500), none);  // 50 ms
  ASSERT_EQ(node.write(0x1800, 5, 20), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(199ms));
  node.expect({"@20000 185#00 00", "@70000 185#00 00", "@120000 185#00 00", "@170000 185#00 00"});
}

TEST(Tpdo, TheEventTimerChangesAtOnce) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 1000), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(500ms));
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.run_until(Time(750ms));
  node.expect({"@600000 185#00 00", "@700000 185#00 00"});
  ASSERT_EQ(node.write(0x1800, 5, 0), none);
  node.run_until(Time(5s));
  node.expect({});
  ASSERT_EQ(node.write(0x1800, 5, 10), none);
  node.run_until(Time(5s + 10ms));
  node.expect({"@5010000 185#00 00"});
}

TEST(Tpdo, TheEventTimerIsForTypes254And255Only) {
  for (unsigned type = 0; type <= 253; ++type) {
    if (type > 240 && type < 252) continue;
    PdoNode node;
    ASSERT_EQ(node.write(0x1800, 5, 10), none);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.run_until(Time(1s));
    node.expect({});
  }
}

}  // namespace
}  // namespace canvoy::tpdo_event_timer_test
