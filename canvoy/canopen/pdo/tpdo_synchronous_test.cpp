#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::tpdo_synchronous_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

constexpr Tpdos::AtStart send_at_start = Tpdos::AtStart::send;

TEST(Tpdo, OfTypes1To240IsSentAtEveryNthSync) {
  for (unsigned type = 1; type <= 240; ++type) {
    PdoNode node(send_at_start);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    for (unsigned sync = 1; sync <= 2 * type; ++sync) {
      node.set(0x2010, 1, sync);
      node.expect({});
      node.receive("080#");
      ASSERT_EQ(node.sent.size(), sync % type == 0 ? 1U : 0U) << type << " at SYNC " << sync;
      if (!node.sent.empty()) {
        ASSERT_EQ(load<std::uint16_t>(node.sent[0].frame.data.data()), sync);
      }
      node.sent.clear();
    }
  }
}

TEST(Tpdo, OfType0IsSentAtTheSyncAfterAChangeOnly) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 0, {0x2010'01'10});
  node.operate();
  node.receive("080#");
  node.expect({});
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 2);
  node.expect({});
  node.receive("080#");
  node.expect({"185#02 00"});
  node.receive("080#");
  node.expect({});
}

TEST(Tpdo, OfType0IsSentThoughTheChangeWasTakenBack) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 0, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 0);
  node.receive("080#");
  node.expect({"185#00 00"});
}

TEST(Tpdo, OfType0IsSentForAnEventOfTheApplication) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 0, {0x2010'01'10});
  node.operate();
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.expect({});
  node.receive("080#");
  node.expect({"185#00 00"});
}

TEST(Tpdo, SamplesWhatTheSameSyncBroughtToAnRpdo) {
  for (const unsigned type : {0U, 1U}) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.receive("205#34 12");
    node.expect({});
    node.receive("080#");
    node.expect({"185#34 12"});
  }
}

TEST(Tpdo, TakesTheSyncWithTheStartValueAsTheFirst) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 10), none);
  ASSERT_EQ(node.write(0x1800, 6, 4), none);
  node.map_tpdo(1, 0x185, 2, {0x2000'01'08});
  node.operate();
  Texts at;
  for (unsigned sync = 1; sync <= 20; ++sync) {
    const unsigned counter = (sync - 1) % 10 + 1;
    node.node.receive(Frame::data_frame(0x80, {static_cast<std::uint8_t>(counter)}), node.now);
    if (!node.sent.empty()) at.push_back(std::to_string(sync));
    node.sent.clear();
  }
  EXPECT_EQ(at, Texts({"5", "7", "9", "11", "13", "15", "17", "19"}));
}

TEST(Tpdo, WaitsForTheStartValueAgainWithEachOperational) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 10), none);
  ASSERT_EQ(node.write(0x1800, 6, 4), none);
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  for (int i = 0; i < 2; ++i) {
    node.operate();
    node.receive("080#03");
    node.expect({});
    node.receive("080#04");
    node.expect({"185#00"});
    node.receive("000#80 00");
  }
}

TEST(Tpdo, DoesNotWaitForTheStartValueWhereSyncHasNoCounter) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 6, 4), none);
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.receive("080#");
  node.expect({"185#00"});
}

TEST(Tpdo, CountsSyncsFromOperationalOn) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 2, {0x2000'01'08});
  node.receive("080#");
  node.operate();
  node.receive("080#");
  node.expect({});
  node.receive("000#80 00");
  node.operate();
  node.receive("080#");
  node.expect({});
  node.receive("080#");
  node.expect({"185#00"});
}

TEST(Tpdo, SynchronousKnowsNoInhibitTime) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 1000), none);
  node.map_tpdo(1, 0x185, 1, {0x2010'01'10});
  node.operate();
  node.receive("080#");
  node.receive("080#");
  node.expect({"@0 185#00 00", "@0 185#00 00"});
}

/// CiA 301 does not define the meaning of a counter that jumps, stands still or is out of range.
TEST(Tpdo, TakesEverySyncForOneWhateverItsCounterIs) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 10), none);
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  for (const char* sync : {"080#01", "080#05", "080#05", "080#04", "080#0B", "080#00", "080#FF"}) {
    node.receive(sync);
    node.expect({"185#00"});
  }
  EXPECT_EQ(node.errors(), Texts());
}

TEST(Tpdo, CountsOnWhereTheCounterOfSyncJumps) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 240), none);
  ASSERT_EQ(node.write(0x1800, 6, 3), none);
  node.map_tpdo(1, 0x185, 3, {0x2000'01'08});
  node.operate();
  for (const char* sync : {"080#01", "080#02", "080#03", "080#07"}) node.receive(sync);
  node.expect({});
  node.receive("080#08");
  node.expect({"185#00"});
}

}  // namespace
}  // namespace canvoy::tpdo_synchronous_test
