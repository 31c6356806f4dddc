// Consumer of multiplexed PDOs in source address mode, and its dispatching lists, frame by frame
// (CiA 301, 7.2.3 and 7.5.2.40).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::mpdo_source_consumer_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;
constexpr unsigned source = 0xFE;

TEST(SamConsumer, WritesTheObjectThatTheDispatchingListGives) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2010'04'6401'02'0A});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#0A 01 64 02 34 12 00 00");
  EXPECT_EQ(node.number(0x2010, 4), 0x1234U);
  EXPECT_EQ(node.errors(), Texts());
}

TEST(SamConsumer, IgnoresWhatNoEntryNames) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2010'04'6401'02'0A});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#0B 01 64 02 34 12 00 00");
  node.receive("18A#0A 02 64 02 34 12 00 00");
  node.receive("18A#0A 01 64 01 34 12 00 00");
  node.receive("18A#0A 01 64 03 34 12 00 00");
  for (std::uint8_t sub = 1; sub <= 8; ++sub) EXPECT_EQ(node.number(0x2010, sub), 0U);
  EXPECT_EQ(node.errors(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 0U);
}

/// The block size is in the uppermost byte; a known stack took it from another.
TEST(SamConsumer, MovesTheSubIndicesOfABlock) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x04'2000'05'6401'02'0A});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  for (unsigned sub = 0; sub <= 0xFF; ++sub) {
    Frame frame = wire_frame("18A#0A 01 64 00 99 00 00 00");
    frame.data[3] = static_cast<std::uint8_t>(sub);
    frame.data[4] = static_cast<std::uint8_t>(0x80 + sub);
    node.node.receive(frame, node.now);
  }
  for (std::uint8_t sub = 1; sub <= 16; ++sub) {
    const bool in_block = sub >= 5 && sub <= 8;
    EXPECT_EQ(node.number(0x2000, sub), in_block ? 0x80U + sub - 3U : 0U) << int{sub};
  }
}

TEST(SamConsumer, IgnoresAndCountsWhereABlockReachesBeyondTheOwnObject) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x08'2000'10'6401'01'0A, 0xFF'2000'01'6500'01'0A});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#0A 01 64 01 01 00 00 00");
  EXPECT_EQ(node.number(0x2000, 16), 1U);
  node.receive("18A#0A 01 64 02 02 00 00 00");
  node.receive("18A#0A 00 65 FE 02 00 00 00");
  EXPECT_EQ(node.errors(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 2U);
}

TEST(SamConsumer, ReachesSubIndex255ButNotBeyond) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0xFF'2000'10'6401'01'0A});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  // FFh - 01h after 10h is 10Eh, which is no sub-index, least of all 0Eh.
  node.receive("18A#0A 01 64 FF 07 00 00 00");
  EXPECT_EQ(node.number(0x2000, 0x0E), 0U);
  EXPECT_EQ(node.node.counters().malformed, 1U);
}

TEST(SamConsumer, ReadsAllListsAndTheFirstEntryThatFits) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2000'01'6000'01'0A, 0, 0x01'2000'02'6000'02'0A});
  node.fill_list(0x1FD1, {0x01'2000'03'6000'02'0A, 0x01'2000'04'6000'03'0B});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#0A 00 60 02 22 00 00 00");
  EXPECT_EQ(node.number(0x2000, 2), 0x22U);
  EXPECT_EQ(node.number(0x2000, 3), 0U) << "the second entry for it is never reached";
  node.receive("18A#0B 00 60 03 33 00 00 00");
  EXPECT_EQ(node.number(0x2000, 4), 0x33U);
}

TEST(SamConsumer, ReadsAsManyEntriesAsSubIndex0Says) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2000'01'6000'01'0A, 0x01'2000'02'6000'02'0A});
  ASSERT_EQ(node.write(0x1FD0, 0, 1), none);
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#0A 00 60 02 22 00 00 00");
  EXPECT_EQ(node.number(0x2000, 2), 0U);
  ASSERT_EQ(node.write(0x1FD0, 0, 2), none);
  node.receive("18A#0A 00 60 02 22 00 00 00");
  EXPECT_EQ(node.number(0x2000, 2), 0x22U) << "a list may change at any time";
}

TEST(SamConsumer, Has254EntriesInAList) {
  MpdoNode node;
  std::vector<std::uint64_t> entries;
  for (std::uint64_t i = 1; i <= 254; ++i) {
    entries.push_back(0x01'2010'01'6000'00'0A + ((i % 8) << 32) + (i << 8));
  }
  node.fill_list(0x1FD0, entries);
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  for (unsigned i = 1; i <= 254; ++i) {
    Frame frame = wire_frame("18A#0A 00 60 00 00 00 00 00");
    frame.data[3] = frame.data[4] = static_cast<std::uint8_t>(i);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.number(0x2010, static_cast<std::uint8_t>(1 + i % 8)), i);
  }
}

TEST(SamConsumer, RefusesAValueOutOfRange) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2060'00'6000'01'0A});
  node.use_rpdo(2, 0x18A, source);
  node.operate();
  node.receive("18A#0A 00 60 01 15 00 00 00");
  EXPECT_EQ(node.errors(), Texts({"+8200/2"}));
  EXPECT_EQ(node.last_error().info, (std::array<std::uint8_t, 5>{2, 0, 0x60, 0x20, 0}));
  node.receive("18A#0A 00 60 01 14 00 00 00");
  EXPECT_EQ(node.errors(), Texts({"-8200/2"}));
  EXPECT_EQ(node.number(0x2060, 0), 0x14U);
}

TEST(SamConsumer, IgnoresAndCountsDestinationAddressesAndNode0) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2000'01'6000'01'05});
  node.use_rpdo(1, 0x18A, source);
  node.operate();
  node.receive("18A#85 00 60 01 07 00 00 00");
  node.receive("18A#80 00 60 01 07 00 00 00");
  node.receive("18A#00 00 60 01 07 00 00 00");
  EXPECT_EQ(node.number(0x2000, 1), 0U);
  EXPECT_EQ(node.errors(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 3U);
}

TEST(DispatchingList, RefusesWhatNoMpdoCanReach) {
  MpdoNode node;
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2FFF'00'6000'01'0A), no_object);
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2000'11'6000'01'0A), no_sub_index);
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2030'00'6000'01'0A), not_mappable) << "8 bytes";
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2070'00'6000'01'0A), not_mappable) << "a string";
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2080'00'6000'01'0A), not_mappable);
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2081'00'6000'01'0A), not_mappable) << "TPDO only";
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2082'00'6000'01'0A), none);
  EXPECT_EQ(node.write(0x1FD0, 1, 0), none) << "an unused entry";
  for (unsigned producer = 0; producer <= 255; ++producer) {
    EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2000'01'6000'01'00 + producer),
              producer >= 1 && producer <= 127 ? none : value_range)
        << producer;
  }
}

TEST(DispatchingList, HasItsDefaultsAgainAfterAReset) {
  MpdoNode node;
  node.fill_list(0x1FD0, {0x01'2000'01'6000'01'0A});
  node.receive("000#82 05");
  EXPECT_EQ(node.number(0x1FD0, 0), 0U);
  EXPECT_EQ(node.number(0x1FD0, 1), 0U);
}

}  // namespace
}  // namespace canvoy::mpdo_source_consumer_test
