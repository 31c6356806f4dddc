#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy {
namespace {

using enum AbortCode;

TEST(Tpdo, ThatFindsNoRoomIsSentLaterWithTheValuesOfThen) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) node.set(0x2000, 1, i);  // 16 of them fit into the backlog
  node.set(0x2000, 2, 1);
  node.set(0x2000, 1, 21);
  node.expect({});
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 18U);
  EXPECT_EQ(wire_text(node.sent[15].frame), "185#10");
  EXPECT_EQ(wire_text(node.sent[16].frame), "185#15") << "not the value of the 17th change";
  EXPECT_EQ(wire_text(node.sent[17].frame), "285#01");
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
  node.node.tx_ready(node.now);
  EXPECT_EQ(node.sent.size(), 18U);
}

TEST(Tpdo, SynchronousThatFindsNoRoomIsSentLaterWithItsSample) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 17; ++i) {
    node.set(0x2000, 1, i);
    node.receive("080#");
  }
  node.set(0x2000, 1, 0x99);
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 17U);
  EXPECT_EQ(wire_text(node.sent[16].frame), "185#11");
}

TEST(Tpdo, ThatWaitsForRoomIsForgottenWhenItBecomesInvalid) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 17; ++i) node.set(0x2000, 1, i);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.full = false;
  node.node.tx_ready(node.now);
  EXPECT_EQ(node.sent.size(), 16U);
}

}  // namespace
}  // namespace canvoy
