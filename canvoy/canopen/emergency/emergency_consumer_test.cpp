#include "canvoy/canopen/emergency/emergency_consumer.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::emergency_consumer_test {
namespace {

// 1028h for the nodes 1 to 12: node 10 by its pre-defined CAN-ID, the others not received.
constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1028, .entry_count = 4}}),
                                std::to_array<EntryRow>({{.access = Access::const_, .initial = 12},
                                                         {.sub_first = 1,
                                                          .sub_last = 9,
                                                          .type = DataType::unsigned32,
                                                          .access = Access::rw,
                                                          .initial = 0x8000'0000},
                                                         {.sub_first = 10,
                                                          .sub_last = 10,
                                                          .type = DataType::unsigned32,
                                                          .access = Access::rw,
                                                          .initial = 0x8A},
                                                         {.sub_first = 11,
                                                          .sub_last = 12,
                                                          .type = DataType::unsigned32,
                                                          .access = Access::rw,
                                                          .initial = 0x8000'0000}}));

// A data sheet with defaults that 1028h could not be given: 29 bits, and a restricted CAN-ID.
constexpr auto odd_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1028, .entry_count = 3}}),
            std::to_array<EntryRow>({{.access = Access::const_, .initial = 2},
                                     {.sub_first = 1,
                                      .sub_last = 1,
                                      .type = DataType::unsigned32,
                                      .access = Access::rw,
                                      .initial = 0x2000'0081},
                                     {.sub_first = 2,
                                      .sub_last = 2,
                                      .type = DataType::unsigned32,
                                      .access = Access::rw,
                                      .initial = 0x581}}));

constexpr auto layout_without =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct HearingNode : WireNode {
  explicit HearingNode(const DictionaryTables& tables = layout.tables())
      : WireNode(tables, 5), consumer(node, slots) {
    consumer.on_emergency(callback<&HearingNode::heard>(*this));
    boot();
  }

  void heard(NodeId node_id, const Emergency& emergency) {
    char text[64];
    std::snprintf(text, sizeof text, "%u: %04X %02X %02X%02X%02X%02X%02X", node_id, emergency.code,
                  emergency.register_bits, emergency.info[0], emergency.info[1], emergency.info[2],
                  emergency.info[3], emergency.info[4]);
    log.emplace_back(text);
  }
  void expect_log(const std::vector<std::string>& expected) {
    EXPECT_EQ(log, expected);
    log.clear();
  }
  AbortCode write(std::uint8_t sub, std::uint32_t value) {
    std::uint8_t bytes[4];
    store(bytes, value);
    return node.dictionary().write(0x1028, sub, bytes, Source::sdo);
  }

  std::vector<std::string> log;
  EmergencyConsumer::Slot slots[2];
  EmergencyConsumer consumer;
};

TEST(EmergencyConsumer, HearsTheNodesOf1028h) {
  HearingNode sut;
  sut.receive("08A#30 81 11 05 00 01 02 03");
  sut.receive("08B#30 81 11 05 00 01 02 03");
  sut.receive("08A#00 00 00 00 00 00 00 00");
  sut.expect_log({"10: 8130 11 0500010203", "10: 0000 00 0000000000"});
}

TEST(EmergencyConsumer, HearsInPreOperationalAndOperationalOnly) {
  HearingNode sut;
  sut.receive("000#01 05");
  sut.receive("08A#10 10 01 00 00 00 00 00");
  sut.receive("000#02 05");
  sut.receive("08A#20 20 02 00 00 00 00 00");
  sut.receive("000#80 05");
  sut.receive("08A#30 30 04 00 00 00 00 00");
  sut.expect_log({"10: 1010 01 0000000000", "10: 3030 04 0000000000"});
}

TEST(EmergencyConsumer, IgnoresAndCountsFramesOfAWrongLength) {
  HearingNode sut;
  for (const char* frame : {"08A#", "08A#30 81", "08A#30 81 11 05 00 01 02"}) sut.receive(frame);
  sut.receive("08A#R8");
  sut.expect_log({});
  EXPECT_EQ(sut.node.counters().malformed, 3U);
}

TEST(EmergencyConsumer, FollowsAWriteTo1028h) {
  HearingNode sut;
  EXPECT_EQ(sut.write(12, 0x0000'0234), AbortCode::none);
  sut.receive("234#00 10 01 00 00 00 00 00");
  sut.expect_log({"12: 1000 01 0000000000"});
  EXPECT_EQ(sut.write(12, 0x8000'0234), AbortCode::none);
  sut.receive("234#00 10 01 00 00 00 00 00");
  sut.expect_log({});
}

TEST(EmergencyConsumer, ChangesACanIdWhileTheEntryIsInvalidOnly) {
  HearingNode sut;
  EXPECT_EQ(sut.write(10, 0x0000'00C0), AbortCode::value_range);
  EXPECT_EQ(sut.write(10, 0x8000'00C0), AbortCode::none);
  EXPECT_EQ(sut.write(10, 0x0000'00C0), AbortCode::none);
  EXPECT_EQ(sut.write(10, 0x2000'00C0), AbortCode::value_range);
  EXPECT_EQ(sut.write(9, 0x0000'0700 + 9), AbortCode::value_range);
  sut.receive("0C0#00 10 01 00 00 00 00 00");
  sut.expect_log({"10: 1000 01 0000000000"});
}

TEST(EmergencyConsumer, HearsAFlippedBitAsAnotherEmergencyOfTheSameNode) {
  // Code 8130h, register 11h, manufacturer field 05 00 01 02 03.
  constexpr std::uint8_t golden[] = {0x30, 0x81, 0x11, 0x05, 0x00, 0x01, 0x02, 0x03};
  for (unsigned bit = 0; bit < 64; ++bit) {
    HearingNode sut;
    Frame frame = Frame::data_frame(0x08A, golden);
    const auto flip = static_cast<std::uint8_t>(1U << bit % 8);
    frame.data.at(bit / 8) ^= flip;
    sut.node.receive(frame, sut.now);
    std::uint8_t expected[8];
    std::copy_n(std::begin(golden), 8, expected);
    expected[bit / 8] ^= flip;
    char text[64];
    std::snprintf(text, sizeof text, "10: %02X%02X %02X %02X%02X%02X%02X%02X", expected[1],
                  expected[0], expected[2], expected[3], expected[4], expected[5], expected[6],
                  expected[7]);
    sut.expect_log({text});
  }
}

TEST(EmergencyConsumer, HearsEveryCanIdThatIsNotRestricted) {
  HearingNode sut;
  for (std::uint32_t can_id = 0; can_id <= 0x7FF; ++can_id) {
    const bool free = (can_id >= 0x080 && can_id <= 0x100) ||
                      (can_id >= 0x180 && can_id <= 0x580) || can_id == 0x600 ||
                      (can_id >= 0x680 && can_id <= 0x6DF) || can_id == 0x700;
    ASSERT_EQ(sut.write(12, can_id), free ? AbortCode::none : AbortCode::value_range) << can_id;
    if (!free) continue;
    sut.node.receive(Frame::data_frame(can_id, {0, 0x10, 1, 0, 0, 0, 0, 0}), sut.now);
    const bool of_both = can_id == 0x8A;
    ASSERT_EQ(sut.log.size(), of_both ? 2U : 1U) << can_id;
    sut.log.clear();
    ASSERT_EQ(sut.write(12, 0x8000'0000), AbortCode::none);
  }
}

TEST(EmergencyConsumer, Refuses29BitsAndWhatIsReserved) {
  HearingNode sut;
  for (unsigned bit = 11; bit <= 30; ++bit) {
    EXPECT_EQ(sut.write(12, 0x8CU | 1U << bit), AbortCode::value_range) << bit;
  }
}

TEST(EmergencyConsumer, RefusesANodeForWhichThereIsNoSlot) {
  HearingNode sut;
  EXPECT_EQ(sut.write(11, 0x8B), AbortCode::none);
  EXPECT_EQ(sut.write(12, 0x8C), AbortCode::out_of_memory);
  EXPECT_EQ(sut.write(11, 0x8B), AbortCode::none) << "the same again needs no other slot";
  EXPECT_EQ(sut.write(11, 0x8000'008B), AbortCode::none);
  EXPECT_EQ(sut.write(12, 0x8C), AbortCode::none);
}

TEST(EmergencyConsumer, TakesTheDefaultsOf1028hByAReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    HearingNode sut;
    sut.write(10, 0x8000'0000);
    sut.write(11, 0x8B);
    sut.receive(reset);
    sut.receive("08A#00 10 01 00 00 00 00 00");
    sut.receive("08B#00 10 01 00 00 00 00 00");
    sut.expect_log({"10: 1000 01 0000000000"});
  }
}

TEST(EmergencyConsumer, HearsWhatTheApplicationAsksForWithout1028h) {
  HearingNode sut(layout_without.tables());
  EXPECT_TRUE(sut.consumer.listen(127));
  EXPECT_TRUE(sut.consumer.listen(9, 0x345));
  EXPECT_FALSE(sut.consumer.listen(11));
  sut.receive("000#82 00");
  sut.receive("0FF#00 10 01 00 00 00 00 00");
  sut.receive("345#00 20 01 00 00 00 00 00");
  sut.receive("08B#00 30 01 00 00 00 00 00");
  sut.expect_log({"127: 1000 01 0000000000", "9: 2000 01 0000000000"});
  sut.consumer.ignore(9);
  sut.receive("345#00 20 01 00 00 00 00 00");
  sut.expect_log({});
}

TEST(EmergencyConsumer, HearsANodeByTheLastCanIdThatItWasGiven) {
  HearingNode sut(layout_without.tables());
  EXPECT_TRUE(sut.consumer.listen(9));
  EXPECT_TRUE(sut.consumer.listen(9, 0x345));
  sut.receive("089#00 10 01 00 00 00 00 00");
  sut.receive("345#00 20 01 00 00 00 00 00");
  sut.expect_log({"9: 2000 01 0000000000"});
}

TEST(EmergencyConsumer, RefusesToListenToWhatIsNoNode) {
  HearingNode sut(layout_without.tables());
  EXPECT_FALSE(sut.consumer.listen(0));
  EXPECT_FALSE(sut.consumer.listen(128));
  EXPECT_FALSE(sut.consumer.listen(255));
  EXPECT_FALSE(sut.consumer.listen(1, 0x800));
}

/// CiA 301, 7.3.5: 581h is of SDO; and no node here hears 29 bits.
TEST(EmergencyConsumer, HearsNothingOnADefaultThatIsNoCanIdForIt) {
  HearingNode node(odd_layout.tables());
  node.receive("081#00 10 01 00 00 00 00 00");
  node.receive("581#00 10 01 00 00 00 00 00");
  node.receive("00000081#00 10 01 00 00 00 00 00");
  node.expect_log({});
}

/// CiA 301, 7.2.7.1: error code, error register, five bytes of the manufacturer.
TEST(EmergencyFrame, HasCodeRegisterAndInformation) {
  const Emergency emergency{.code = 0x8130, .register_bits = 0x11, .info = {1, 2, 3, 4, 5}};
  EXPECT_EQ(wire_text(encode(emergency, 0x085)), "085#30 81 11 01 02 03 04 05");
}

}  // namespace
}  // namespace canvoy::emergency_consumer_test
