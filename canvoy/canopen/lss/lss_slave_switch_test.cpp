// LSS slave, switch state services: global and selective.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_slave_switch_test {
namespace {

using Texts = std::vector<std::string>;

constexpr const char* select_vendor = "7E5#40 04 03 02 01";
constexpr const char* select_product = "7E5#41 14 13 12 11";
constexpr const char* select_revision = "7E5#42 24 23 22 21";
constexpr const char* select_serial = "7E5#43 34 33 32 31";
const Texts select_all = {select_vendor, select_product, select_revision, select_serial};

TEST(LssSwitchGlobal, LeadsToConfigurationAndBackWithoutAnAnswer) {
  LssNode node(5);
  node.up();
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.receive("7E5#04 01");
  EXPECT_EQ(node.lss.state(), LssState::configuration);
  node.receive("7E5#04 01");
  EXPECT_EQ(node.lss.state(), LssState::configuration);
  node.receive("7E5#04 00");
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.answers({});
  EXPECT_EQ(node.application.take(), Texts({"configuration", "waiting"}));
}

TEST(LssSwitchGlobal, KnowsTwoModesOnly) {
  for (unsigned mode = 2; mode < 256; ++mode) {
    LssNode node(5);
    node.up();
    for (const LssState before : {LssState::waiting, LssState::configuration}) {
      node.receive(before == LssState::waiting ? "7E5#04 00" : "7E5#04 01");
      Frame frame = wire_frame(lss_frame("7E5#04"));
      frame.data[1] = static_cast<std::uint8_t>(mode);
      node.node.receive(frame, node.now);
      EXPECT_EQ(node.lss.state(), before) << mode;
    }
    EXPECT_EQ(node.node.counters().malformed, 2U) << mode;
    node.answers({});
  }
}

TEST(LssSwitchGlobal, WorksInEveryNmtState) {
  for (const char* command : {"000#80 00", "000#01 00", "000#02 00"}) {
    LssNode node(5);
    node.up();
    node.receive(command);
    const NmtState state = node.node.state();
    node.receive("7E5#04 01");
    EXPECT_EQ(node.lss.state(), LssState::configuration) << command;
    EXPECT_EQ(node.node.state(), state) << command;
  }
  LssNode unconfigured(node_id_unconfigured);
  unconfigured.up();
  unconfigured.receive("7E5#04 01");
  EXPECT_EQ(unconfigured.lss.state(), LssState::configuration);
}

TEST(LssSwitchGlobal, IsNotHeardBeforeTheNodeWasStarted) {
  LssNode node(node_id_unconfigured);
  node.receive_all({"7E5#04 01", "7E5#11 05", "7E5#04 00"});
  EXPECT_EQ(node.node.state(), NmtState::initialisation);
  node.answers({});
}

TEST(LssSwitchSelective, LeadsToConfigurationTheNodeOfThisAddress) {
  LssNode node(5);
  node.up();
  node.receive_all({select_vendor, select_product, select_revision});
  node.answers({});
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.receive(select_serial);
  node.answers({"7E4#44"});
  EXPECT_EQ(node.lss.state(), LssState::configuration);
}

TEST(LssSwitchSelective, LeavesAloneANodeWithAnyBitOfTheAddressDifferent) {
  for (std::size_t part = 0; part < 4; ++part) {
    for (unsigned bit = 0; bit < 32; ++bit) {
      LssAddress other = lss_address;
      other.parts[part] ^= 1U << bit;
      LssNode node(5, other);
      node.up();
      node.receive_all(select_all);
      node.answers({});
      EXPECT_EQ(node.lss.state(), LssState::waiting) << part << ' ' << bit;
    }
  }
}

TEST(LssSwitchSelective, NeedsItsFourMessagesInTheirOrder) {
  for (unsigned order = 0; order < 256; ++order) {
    LssNode node(5);
    node.up();
    for (unsigned i = 0; i < 4; ++i) node.receive(select_all[order >> 2 * i & 3]);
    const bool in_order = order == (0U | 1U << 2 | 2U << 4 | 3U << 6);
    EXPECT_EQ(node.lss.state() == LssState::configuration, in_order) << order;
    EXPECT_EQ(node.sent.size(), in_order ? 1U : 0U) << order;
  }
}

TEST(LssSwitchSelective, EndsWithAnotherServiceInBetweenAndMayBeginAfresh) {
  LssNode node(5);
  node.up();
  node.receive_all({select_vendor, select_product, "7E5#4C", select_revision, select_serial});
  node.answers({});
  node.receive_all({select_vendor, select_vendor, select_product, select_revision, select_serial});
  node.answers({"7E4#44"});
}

TEST(LssSwitchSelective, IsNotAnsweredInConfiguration) {
  LssNode node(5);
  node.in_configuration().receive_all(select_all);
  node.answers({});
  EXPECT_EQ(node.lss.state(), LssState::configuration);
}

TEST(LssSwitchSelective, TakesNoStepFromBeforeAReset) {
  LssNode node(5);
  node.up();
  node.receive_all({select_vendor, select_product, "000#82 00", select_revision, select_serial});
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.answers({"705#00"});
}

TEST(LssSlave, IsInWaitingAfterEachNmtReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    LssNode node(5);
    node.in_configuration().receive(reset);
    EXPECT_EQ(node.lss.state(), LssState::waiting);
    node.answers({"705#00"});
  }
}

}  // namespace
}  // namespace canvoy::lss_slave_switch_test
