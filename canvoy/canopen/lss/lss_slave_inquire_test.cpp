// LSS slave, inquiry and identification services.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/lss_node.hpp"

namespace canvoy::lss_slave_inquire_test {
namespace {

using Texts = std::vector<std::string>;

TEST(LssInquire, TellsEachPartOfTheIdentity) {
  LssNode node(5);
  node.in_configuration().receive_all({"7E5#5A", "7E5#5B", "7E5#5C", "7E5#5D"});
  node.answers(
      {"7E4#5A 04 03 02 01", "7E4#5B 14 13 12 11", "7E4#5C 24 23 22 21", "7E4#5D 34 33 32 31"});
}

TEST(LssInquire, TellsTheNodeIdThatIsInUse) {
  LssNode node(0x7F);
  node.in_configuration().receive_all({"7E5#5E", "7E5#11 06", "7E5#5E"});
  node.answers({"7E4#5E 7F", "7E4#11 00", "7E4#5E 7F"});
  LssNode unconfigured(node_id_unconfigured);
  unconfigured.in_configuration().receive("7E5#5E");
  unconfigured.answers({"7E4#5E FF"});
}

TEST(LssInquire, IsNotAnsweredInWaiting) {
  LssNode node(5);
  node.up().receive_all({"7E5#5A", "7E5#5B", "7E5#5C", "7E5#5D", "7E5#5E"});
  node.answers({});
  EXPECT_EQ(node.node.counters().malformed, 0U) << "they are for another node";
}

TEST(LssInquire, TellsZerosWhereTheNodeHasNoIdentity) {
  constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
                                  std::to_array<EntryRow>({{.type = DataType::unsigned32}}));
  WireNode node(layout.tables(), 5);
  LssSlave lss(node.node);
  node.boot();
  for (const char* frame : {"7E5#04 01", "7E5#5A", "7E5#5D"}) node.receive(lss_frame(frame));
  node.expect({"7E4#5A 00 00 00 00 00 00 00", "7E4#5D 00 00 00 00 00 00 00"});
}

const Texts identify_exactly = {"7E5#46 04 03 02 01", "7E5#47 14 13 12 11", "7E5#48 24 23 22 21",
                                "7E5#49 24 23 22 21", "7E5#4A 34 33 32 31", "7E5#4B 34 33 32 31"};

TEST(LssIdentify, IsAnsweredByTheNodeOfThisAddressInBothStates) {
  LssNode node(5);
  node.up().receive_all(identify_exactly);
  node.answers({"7E4#4F"});
  EXPECT_EQ(node.lss.state(), LssState::waiting);
  node.receive("7E5#04 01");
  node.receive_all(identify_exactly);
  node.answers({"7E4#4F"});
}

TEST(LssIdentify, TakesRangesOfRevisionAndSerialNumberWithTheirEnds) {
  const auto answered = [](std::size_t step, const char* frame) {
    LssNode node(5);
    Texts frames = identify_exactly;
    frames[step] = frame;
    node.up().receive_all(frames);
    return node.sent.size() == 1;
  };
  EXPECT_TRUE(answered(2, "7E5#48 00 00 00 00"));
  EXPECT_TRUE(answered(2, "7E5#48 23 23 22 21"));
  EXPECT_FALSE(answered(2, "7E5#48 25 23 22 21"));
  EXPECT_FALSE(answered(2, "7E5#48 FF FF FF FF"));
  EXPECT_TRUE(answered(3, "7E5#49 FF FF FF FF"));
  EXPECT_TRUE(answered(3, "7E5#49 25 23 22 21"));
  EXPECT_FALSE(answered(3, "7E5#49 23 23 22 21"));
  EXPECT_TRUE(answered(4, "7E5#4A 00 00 00 00"));
  EXPECT_FALSE(answered(4, "7E5#4A 35 33 32 31"));
  EXPECT_TRUE(answered(5, "7E5#4B FF FF FF FF"));
  EXPECT_FALSE(answered(5, "7E5#4B 33 33 32 31"));
}

TEST(LssIdentify, NeedsVendorAndProductBitByBit) {
  for (std::size_t part = 0; part < 2; ++part) {
    for (unsigned bit = 0; bit < 32; ++bit) {
      LssAddress other = lss_address;
      other.parts[part] ^= 1U << bit;
      LssNode node(5, other);
      node.up().receive_all(identify_exactly);
      node.answers({});
    }
  }
}

TEST(LssIdentify, NeedsItsSixMessagesInTheirOrder) {
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = a + 1; b < 6; ++b) {
      LssNode node(5);
      Texts frames = identify_exactly;
      std::swap(frames[a], frames[b]);
      node.up().receive_all(frames);
      node.answers({});
    }
    LssNode node(5);
    Texts frames = identify_exactly;
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(a));
    node.up().receive_all(frames);
    node.answers({});
  }
}

TEST(LssIdentify, IsNotMixedWithSwitching) {
  LssNode node(5);
  node.up().receive_all({"7E5#46 04 03 02 01", "7E5#40 04 03 02 01", "7E5#47 14 13 12 11",
                         "7E5#41 14 13 12 11", "7E5#48", "7E5#42 24 23 22 21",
                         "7E5#43 34 33 32 31"});
  node.answers({});
  EXPECT_EQ(node.lss.state(), LssState::waiting);
}

TEST(LssIdentifyUnconfigured, IsAnsweredByNodesWithoutNodeIdInBothStates) {
  LssNode node(node_id_unconfigured);
  node.up().receive("7E5#4C");
  node.answers({"7E4#50"});
  node.receive_all({"7E5#04 01", "7E5#4C"});
  node.answers({"7E4#50"});
  node.receive_all({"7E5#11 07", "7E5#4C"});
  node.answers({"7E4#11"});  // one is on its way to it
}

TEST(LssIdentifyUnconfigured, IsNotAnsweredByNodesWithNodeId) {
  LssNode node(5);
  node.up().receive("7E5#4C");
  node.answers({});
  node.receive_all({"7E5#04 01", "7E5#11 FF", "7E5#4C"});
  node.answers({"7E4#11"});
}

}  // namespace
}  // namespace canvoy::lss_slave_inquire_test
