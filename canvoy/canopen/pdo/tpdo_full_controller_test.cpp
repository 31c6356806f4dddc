#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_full_controller_test {
namespace {

using enum AbortCode;

TEST(Tpdo, ThatFindsNoRoomIsSentLaterWithTheValuesOfThen) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) node.set(0x2000, 1, i);  // 8 of them fit
  node.set(0x2000, 2, 1);
  node.set(0x2000, 1, 21);
  node.expect({});
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 10U);
  EXPECT_EQ(wire_text(node.sent[7].frame), "185#08");
  EXPECT_EQ(wire_text(node.sent[8].frame), "185#15") << "not the value of the 9th change";
  EXPECT_EQ(wire_text(node.sent[9].frame), "285#01");
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
  node.node.tx_ready(node.now);
  EXPECT_EQ(node.sent.size(), 10U);
}

TEST(Tpdo, OfANodeWithoutABacklogIsSentWhenTheControllerHasRoomAgain) {
  PdoNode node(Tpdos::AtStart::wait_for_event, true, 0);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.full = true;
  node.set(0x2000, 1, 1);
  node.set(0x2000, 1, 2);
  node.expect({});
  node.full = false;
  node.node.tx_ready(node.now);
  node.expect({"185#02"});
}

TEST(Tpdo, OfWhichBusOffTookTheFrameIsSentAfterIt) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 1, {0x2000'02'08});
  node.operate();
  node.full = true;
  node.set(0x2000, 1, 1);
  node.set(0x2000, 2, 2);
  node.receive("080#");
  node.node.bus_state(BusState::bus_off, node.now);
  node.run_for(100ms);
  node.expect({});
  node.full = false;
  node.node.bus_state(BusState::error_active, node.now);
  node.expect({"185#01"});
  node.node.tx_ready(node.now);
  node.expect({});
}

TEST(Tpdo, OfABusOffHasTheLastOfItsValues) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.node.bus_state(BusState::error_passive, node.now);
  node.expect({});
  node.full = true;
  node.node.bus_state(BusState::bus_off, node.now);
  node.set(0x2000, 1, 1);
  node.set(0x2000, 1, 2);
  node.full = false;
  node.node.bus_state(BusState::error_passive, node.now);
  node.node.tx_ready(node.now);
  node.expect({"185#02"});
}

TEST(Tpdo, LeavesHalfOfTheBacklogToAnswersErrorControlAndSync) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 1, {0x2000'02'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) {
    node.set(0x2000, 1, i);
    node.receive("080#");
  }
  for (unsigned i = 1; i <= 8; ++i) {
    EXPECT_TRUE(node.node.transmitter().send(wire_frame("585#60 00 20 01 00 00 00 00"))) << i;
  }
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 18U) << "8 PDOs, 8 answers, and of each PDO one that waited";
  EXPECT_EQ(wire_text(node.sent[15].frame), "585#60 00 20 01 00 00 00 00");
  EXPECT_EQ(wire_text(node.sent[16].frame), "185#14");
  EXPECT_EQ(wire_text(node.sent[17].frame), "285#00");
}

TEST(Tpdo, SynchronousThatFindsNoRoomIsSentLaterWithItsSample) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 9; ++i) {
    node.set(0x2000, 1, i);
    node.receive("080#");
  }
  node.set(0x2000, 1, 0x99);
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 9U);
  EXPECT_EQ(wire_text(node.sent[8].frame), "185#09");
}

TEST(Tpdo, ThatBecomesInvalidIsForgottenWithWhatWaitsForRoom) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 9; ++i) node.set(0x2000, 1, i);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.full = false;
  node.node.tx_ready(node.now);
  node.expect({});
}

/// Fills the controller and half of the backlog by TPDO 2: there is no room for process data.
void fill_controller(PdoNode& node) {
  node.full = true;
  for (unsigned i = 1; i <= 8; ++i) node.set(0x2000, 2, i);
}
/// The frames after the 8 of fill_controller().
std::vector<std::string> empty_controller(PdoNode& node) {
  node.full = false;
  node.node.tx_ready(node.now);
  std::vector<std::string> behind;
  for (std::size_t i = 8; i < node.sent.size(); ++i) {
    behind.push_back(wire_text(node.sent[i].frame));
  }
  node.sent.clear();
  return behind;
}

TEST(Tpdo, SynchronousThatFindsNoRoomWithinTheWindowIsLeftOutUntilItsNextTurn) {
  for (const unsigned type : {0U, 1U}) {
    for (const bool in_time : {true, false}) {
      PdoNode node;
      ASSERT_EQ(node.write(0x1007, 0, 2000), none);
      node.map_tpdo(1, 0x185, type, {0x2000'01'08});
      node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
      node.operate();
      node.run_until(Time(10ms));
      fill_controller(node);
      node.set(0x2000, 1, 7);
      node.receive("080#");
      node.run_until(in_time ? Time(12ms) : Time(12ms + 1us));
      EXPECT_EQ(empty_controller(node), std::vector<std::string>(in_time ? 1 : 0, "185#07"));
      node.run_until(Time(20ms));
      node.node.tx_ready(node.now);
      node.expect({});
      node.receive("080#");
      if (type == 0 && in_time) {
        node.expect({});
      } else {
        node.expect({"185#07"});
      }
    }
  }
}

TEST(Tpdo, OfType252IsNotBoundByTheWindow) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1007, 0, 2000), none);
  node.map_tpdo(1, 0x185, 252, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.operate();
  node.receive("080#");
  node.run_until(Time(10ms));
  node.receive("185#R1");
  node.expect({"185#00"});
  fill_controller(node);
  node.receive("185#R1");
  EXPECT_EQ(empty_controller(node), std::vector<std::string>({"185#00"}));
}

}  // namespace
}  // namespace canvoy::tpdo_full_controller_test
