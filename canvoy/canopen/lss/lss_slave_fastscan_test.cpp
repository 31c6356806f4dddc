// LSS slave, Fastscan: a binary search for an unknown node.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_slave_fastscan_test {
namespace {

using Texts = std::vector<std::string>;

Frame scan(std::uint32_t id, unsigned bit_checked, unsigned sub, unsigned next) {
  Frame frame = wire_frame("7E5#51 00 00 00 00 00 00 00");
  store(&frame.data[1], id);
  frame.data[5] = static_cast<std::uint8_t>(bit_checked);
  frame.data[6] = static_cast<std::uint8_t>(sub);
  frame.data[7] = static_cast<std::uint8_t>(next);
  return frame;
}

/// True if the slave answers.
bool ask(LssNode& node, std::uint32_t id, unsigned bit_checked, unsigned sub, unsigned next) {
  node.sent.clear();
  node.node.receive(scan(id, bit_checked, sub, next), node.now);
  if (node.sent.empty()) return false;
  node.answers({"7E4#4F"});
  return true;
}

/// Brings the slave to this scan position.
void confirm_up_to(LssNode& node, unsigned sub) {
  EXPECT_TRUE(ask(node, 0, 0x80, 0, 0));
  for (unsigned part = 0; part < sub; ++part) {
    EXPECT_TRUE(ask(node, lss_address.parts[part], 0, part, part + 1));
  }
}

TEST(LssFastscanSlave, BeginsWithAnAnswerOfAllThatTakePart) {
  LssNode node(node_id_unconfigured);
  node.up().receive("7E5#51 00 00 00 00 80 00 00");
  node.answers({"7E4#4F"});
}

TEST(LssFastscanSlave, FindsEachBitOfEachPartByItsAnswers) {
  LssNode node(node_id_unconfigured);
  node.up();
  ASSERT_TRUE(ask(node, 0, 0x80, 0, 0));
  for (unsigned part = 0; part < 4; ++part) {
    std::uint32_t found = 0;
    for (unsigned bit = 32; bit-- > 0;) {
      if (!ask(node, found, bit, part, part)) found |= 1U << bit;
    }
    EXPECT_EQ(found, lss_address.parts[part]);
    EXPECT_EQ(node.lss.state(), LssState::waiting);
    EXPECT_TRUE(ask(node, found, 0, part, (part + 1) % 4));
  }
  EXPECT_EQ(node.lss.state(), LssState::configuration);
  EXPECT_FALSE(ask(node, 0, 0x80, 0, 0)) << "it takes part no more";
}

TEST(LssFastscanSlave, AnswersTheGoldenFrames) {
  LssNode node(node_id_unconfigured);
  node.up().receive_all({"7E5#51 00 00 00 00 80 00 00",    // all slaves
                         "7E5#51 00 00 00 00 1F 00 00",    // vendor 0.......
                         "7E5#51 00 00 00 00 18 00 00",    // bit 24 is set: silence
                         "7E5#51 00 00 00 01 18 00 00",    // vendor 01......
                         "7E5#51 04 03 02 01 00 00 01",    // vendor confirmed
                         "7E5#51 04 03 02 01 00 00 01",    // no more at vendor: silence
                         "7E5#51 14 13 12 11 00 01 02",    // product confirmed
                         "7E5#51 24 23 22 21 00 02 03",    // revision confirmed
                         "7E5#51 34 33 32 31 00 03 00"});  // serial: selected
  node.answers(Texts(7, "7E4#4F"));
  EXPECT_EQ(node.lss.state(), LssState::configuration);
}

// Every LSSSub and LSSNext, at every scan position, for every BitChecked.
TEST(LssFastscanSlave, HasAnAnswerForEveryEdge) {
  for (unsigned position = 0; position < 4; ++position) {
    for (unsigned sub = 0; sub < 6; ++sub) {
      for (unsigned next = 0; next < 6; ++next) {
        for (const unsigned bit : {0U, 1U, 15U, 31U, 32U, 127U, 0x80U, 0x81U, 255U}) {
          LssNode node(node_id_unconfigured);
          node.up();
          confirm_up_to(node, position);
          const std::uint32_t id = lss_address.parts[sub % 4];
          const bool valid = sub < 4 && next < 4 && bit < 32;
          const bool answered = ask(node, id, bit, sub, next);
          EXPECT_EQ(answered, bit == 0x80 || (valid && sub == position))
              << position << sub << next << ' ' << bit;
          const bool selected = valid && sub == position && bit == 0 && next < sub;
          EXPECT_EQ(node.lss.state() == LssState::configuration, selected)
              << position << sub << next << ' ' << bit;
          EXPECT_EQ(node.node.counters().malformed, valid || bit == 0x80 ? 0U : 1U);
          if (selected) continue;
          // Position afterwards.
          const unsigned after = bit == 0x80                            ? 0
                                 : valid && sub == position && bit == 0 ? next
                                                                        : position;
          EXPECT_TRUE(ask(node, lss_address.parts[after], 1, after, after));
          EXPECT_FALSE(ask(node, lss_address.parts[(after + 1) % 4], 1, (after + 1) % 4, 0));
        }
      }
    }
  }
}

TEST(LssFastscanSlave, ComparesFromBit31DownToTheBitThatIsChecked) {
  for (unsigned checked = 0; checked < 32; ++checked) {
    for (unsigned bit = 0; bit < 32; ++bit) {
      LssNode node(node_id_unconfigured);
      node.up();
      EXPECT_EQ(ask(node, lss_address.parts[0] ^ 1U << bit, checked, 0, 0), bit < checked);
    }
  }
}

TEST(LssFastscanSlave, BeginsAnewAtTheVendorWithEachFirstMessage) {
  LssNode node(node_id_unconfigured);
  node.up();
  confirm_up_to(node, 3);
  EXPECT_TRUE(ask(node, 0, 0x80, 3, 3));
  EXPECT_FALSE(ask(node, lss_address.parts[3], 1, 3, 3));
  EXPECT_TRUE(ask(node, lss_address.parts[0], 1, 0, 0));
}

TEST(LssFastscanSlave, LeavesOutNodesWithNodeIdAndThoseInConfiguration) {
  LssNode configured(5);
  configured.up();
  EXPECT_FALSE(ask(configured, 0, 0x80, 0, 0));
  EXPECT_FALSE(ask(configured, lss_address.parts[0], 0, 0, 1));
  LssNode busy(node_id_unconfigured);
  busy.in_configuration();
  EXPECT_FALSE(ask(busy, 0, 0x80, 0, 0));
  EXPECT_FALSE(ask(busy, lss_address.parts[0], 0, 0, 1));
  LssNode leaving(5);
  leaving.in_configuration().receive_all({"7E5#11 FF", "7E5#04 00"});
  EXPECT_FALSE(ask(leaving, 0, 0x80, 0, 0)) << "it has a node-ID until it is reset";
}

TEST(LssFastscanSlave, KnowsNoOrderOfConfigurationByItself) {
  LssNode node(node_id_unconfigured);
  node.up();
  confirm_up_to(node, 3);
  EXPECT_TRUE(ask(node, lss_address.parts[3], 0, 3, 3)) << "LSSNext is not below LSSSub";
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  EXPECT_TRUE(ask(node, lss_address.parts[3], 0, 3, 0));
  EXPECT_EQ(node.lss.state(), LssState::configuration);
  node.receive_all({"7E5#11 0A", "7E5#04 00"});
  EXPECT_EQ(node.node.id(), 10);
}

}  // namespace
}  // namespace canvoy::lss_slave_fastscan_test
