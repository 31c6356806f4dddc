// Static PDOs: a device on which no master can write the records of PDOs, nor the parameters of
// SYNC and emergency (CiA 301, 7.5.2.35 to 7.5.2.38).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/testing/static_pdo_node.hpp"

namespace canvoy::pdo_static_test {
namespace {

using Static = StaticPdoNode<static_pdo_layout>;
using Writable = StaticPdoNode<writable_pdo_layout>;

static_assert(decltype(Static::device)::rpdo_records == PdoRecords::constant);
static_assert(decltype(Static::device)::tpdo_records == PdoRecords::constant);
static_assert(decltype(Writable::device)::rpdo_records == PdoRecords::writable);
static_assert(decltype(Writable::device)::tpdo_records == PdoRecords::writable);

/// 40h, and the multiplexer in the form of the wire.
std::string sdo_frame(unsigned command, unsigned index, unsigned sub, unsigned value = 0) {
  Frame frame;
  frame.id = 0x605;
  frame.length = 8;
  frame.data = {static_cast<std::uint8_t>(command),    static_cast<std::uint8_t>(index),
                static_cast<std::uint8_t>(index >> 8), static_cast<std::uint8_t>(sub),
                static_cast<std::uint8_t>(value),      static_cast<std::uint8_t>(value >> 8)};
  return wire_text(frame);
}

/// Selects those among all frames sent.
std::vector<std::string> take_emergencies(Static& node) {
  std::vector<std::string> frames = node.take_sent();
  std::erase_if(frames,
                [](const std::string& frame) { return frame.find("085#") == std::string::npos; });
  return frames;
}

TEST(StaticPdo, IsReadByMastersWithTheNodeIdInItsCobId) {
  Static node;
  node.receive("605#40 00 14 01 00 00 00 00");
  node.receive("605#40 00 16 02 00 00 00 00");
  node.receive("605#40 02 18 01 00 00 00 00");
  node.receive("605#40 00 18 03 00 00 00 00");
  node.receive("605#40 05 10 00 00 00 00 00");
  node.receive("605#40 14 10 00 00 00 00 00");
  node.expect({"585#43 00 14 01 05 02 00 00", "585#43 00 16 02 08 00 05 00",
               "585#43 02 18 01 85 03 00 40", "585#4B 00 18 03 64 00 00 00",
               "585#43 05 10 00 80 00 00 00", "585#43 14 10 00 85 00 00 00"});
}

// 0601 0002h for each existing entry, in every state that has SDO, without a change.
TEST(StaticPdo, RefusesEveryWriteToItsRecords) {
  const DictionaryTables tables = static_pdo_layout.tables();
  for (const char* state : {"000#80 00", "000#01 00"}) {
    Static node;
    node.receive(state);
    node.sent.clear();
    unsigned refused = 0;
    for (const ObjectRow& object : tables.objects) {
      const bool is_parameter = object.index < 0x2000 && object.index != 0x1001;
      if (!is_parameter) continue;
      for (const EntryShape& row : tables.entries_of(object)) {
        const std::uint64_t before = node.number(object.index, row.sub_first);
        const unsigned command = 0x23 | (4U - row.capacity) << 2;
        node.receive(sdo_frame(command, object.index, row.sub_first, 1));
        std::string answer = sdo_frame(0x80, object.index, row.sub_first).replace(0, 3, "585");
        node.expect({answer.replace(16, 11, "02 00 01 06")});
        EXPECT_EQ(node.number(object.index, row.sub_first), before);
        ++refused;
      }
    }
    EXPECT_EQ(refused, 54U);
  }
}

TEST(StaticPdo, TakesItsFramesInOperationalOnly) {
  Static node;
  node.receive("205#34 12 FF 78 56");
  EXPECT_EQ(node.number(0x2001, 1), 0U);
  node.operate();
  node.receive("205#34 12 FF 78 56");
  node.receive("405#05");
  EXPECT_EQ(node.number(0x2001, 1), 0x1234U);
  EXPECT_EQ(node.number(0x2001, 2), 0x5678U) << "behind a gap of 8 bits";
  EXPECT_EQ(node.number(0x2003, 1), 1U);
  EXPECT_EQ(node.number(0x2003, 2), 0U);
  EXPECT_EQ(node.number(0x2003, 3), 1U);
  node.receive("000#02 00");
  node.receive("205#00 00 00 00 00");
  EXPECT_EQ(node.number(0x2001, 1), 0x1234U);
}

TEST(StaticPdo, ThatIsTooShortIsAnError8210hAndThatIsTooLongIsTakenWith8220h) {
  Static node;
  node.operate();
  node.sent.clear();
  node.receive("205#34 12 FF 78");
  EXPECT_EQ(node.number(0x2001, 1), 0U);
  node.expect({"085#10 82 11 01 00 00 00 00"});
  node.receive("205#34 12 FF 78 56 AA");
  EXPECT_EQ(node.number(0x2001, 2), 0x5678U);
  node.expect({"085#00 00 00 00 00 00 00 00", "085#20 82 11 01 00 00 00 00"});
  node.receive("205#34 12 FF 78 56");
  node.expect({"085#00 00 00 00 00 00 00 00"});
}

TEST(StaticPdo, ThatDoesNotComeInTimeIsAnError8250h) {
  Static node;
  node.operate();
  node.receive("205#00 00 00 00 00");
  node.run_for(99'999us);
  node.receive("205#00 00 00 00 00");
  node.run_for(99'999us);
  EXPECT_EQ(take_emergencies(node), std::vector<std::string>{});
  node.run_for(1us);
  EXPECT_EQ(take_emergencies(node),
            std::vector<std::string>({"@199999 085#50 82 11 01 00 00 00 00"}));
  node.receive("205#00 00 00 00 00");
  EXPECT_EQ(take_emergencies(node),
            std::vector<std::string>({"@199999 085#00 00 00 00 00 00 00 00"}));
}

TEST(StaticPdo, OfASynchronousTypeIsTakenAtTheNextSyncUnlessItsWindowIsOver) {
  Static node;
  node.operate();
  node.receive("080#01");
  node.receive("305#0B");
  EXPECT_EQ(node.number(0x2002, 0), 15U);
  node.receive("080#02");
  EXPECT_EQ(node.number(0x2002, 0), 11U);
  node.run_for(5001us);
  node.receive("305#0C");
  node.receive("080#03");
  EXPECT_EQ(node.number(0x2002, 0), 11U);
}

TEST(StaticPdo, WithAValueOutOfRangeIsAnError8200hThatNamesTheObject) {
  Static node;
  node.operate();
  node.receive("080#01");
  node.receive("305#15");
  node.sent.clear();
  node.receive("080#02");
  node.expect({"085#00 82 11 02 00 02 20 00"});
  EXPECT_EQ(node.number(0x2002, 0), 15U);
}

TEST(StaticPdo, IsSentAtAChangeWithinItsInhibitTimeAndWhenItsEventTimerExpires) {
  Static node;
  node.operate();
  EXPECT_EQ(node.take_sent(), std::vector<std::string>({"@0 185#00 00"}));
  node.run_for(4ms);
  node.set(0x2000, 1, 0x1234);
  EXPECT_EQ(node.take_sent(), std::vector<std::string>{});
  node.run_for(6ms);
  EXPECT_EQ(node.take_sent(), std::vector<std::string>({"@10000 185#34 12"}));
  node.run_for(50ms);
  EXPECT_EQ(node.take_sent(), std::vector<std::string>({"@60000 185#34 12"}));
}

// SYNC counter 3 starts the count of the cyclic one; the acyclic one needs an event.
TEST(StaticPdo, OfASynchronousTypeIsSentFromItsStartValueOn) {
  Static node;
  node.operate();
  node.receive("080#01");
  node.sent.clear();
  node.receive("080#02");
  node.expect({});
  node.receive("080#03");
  node.expect({});
  node.receive("080#04");
  node.expect({"285#00 00"});
  node.set(0x2000, 3, 0xABCD);
  node.receive("080#05");
  node.expect({"385#CD AB"});
  node.receive("080#06");
  node.expect({"285#00 00"});
}

TEST(StaticPdo, AnswersRemoteFramesAsItsTypeAndBit30Say) {
  Static node;
  node.operate();
  node.sent.clear();
  node.set(0x2000, 4, 0x1111);
  node.set(0x2000, 5, 0x2222);
  node.receive("485#R2");
  node.expect({"485#11 11"});
  node.receive("385#R2");
  node.expect({});
  node.receive("080#01");
  node.set(0x2000, 5, 0x3333);
  node.sent.clear();
  node.receive("1F0#R3");
  node.expect({"1F0#44 44 00"});
}

TEST(StaticPdo, FollowsTheNodeIdAtAResetOfTheCommunication) {
  Static node;
  node.device.node().set_pending_id(0x20);
  node.receive("000#82 00");
  node.operate();
  node.expect({"720#00", "1A0#00 00"});
  node.receive("205#34 12 FF 78 56");
  EXPECT_EQ(node.number(0x2001, 1), 0U);
  node.receive("220#34 12 FF 78 56");
  EXPECT_EQ(node.number(0x2001, 1), 0x1234U);
}

TEST(StaticPdo, ThatTheDeviceItselfMapsBeyond64BitsIsOff) {
  Static node;
  auto map_more = [&](ResetScope) { node.device.dictionary().set_number(0x1A00, 1, 0x2000'0180); };
  node.device.node().on_defaults_restored(Callback<void(ResetScope)>::of(map_more));
  node.receive("000#82 00");
  node.operate();
  node.expect({"705#00"});
}

TEST(StaticPdo, WaitsForRoomInTheController) {
  Static node;
  node.operate();
  node.run_for(20ms);
  node.sent.clear();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) node.receive("605#40 00 14 01 00 00 00 00");
  node.set(0x2000, 1, 0x55AA);
  node.expect({});
  node.make_room();
  EXPECT_EQ(wire_text(wire_frame(node.sent.back().substr(node.sent.back().find(' ') + 1))),
            "185#AA 55");
}

/// One step on the bus, the same for both.
template <class Node>
void live(Node& node, unsigned what, unsigned with) {
  static constexpr const char* ids[] = {"205", "305", "405", "185", "285",
                                        "385", "485", "1F0", "080", "206"};
  const std::string id = ids[with % 10];
  std::string data;
  for (unsigned i = 0; i < with / 10 % 9; ++i) data += i % 2 == 0 ? "0F" : "1A";
  static constexpr const char* commands[] = {"000#01 00", "000#80 00", "000#02 05", "000#81 05",
                                             "000#82 05", "000#01 05", "000#01 00", "000#01 00"};
  switch (what) {
    case 0:
    case 1:
      return node.receive(id + "#" + data);
    case 2:
      return node.receive(id + "#R" + std::to_string(with / 10 % 9));
    case 3:
      return node.receive(std::string("080#0") + "0123456789"[with % 10]);
    case 4:
      return node.run_for(Duration(with * with));
    case 5:
      return node.set(0x2000, static_cast<std::uint8_t>(1 + with % 5), with / 5);
    case 6:
      return with % 4 == 0 ? node.receive(commands[with / 4 % 8]) : node.run_for(Duration(with));
    case 7:
      if (with % 8 == 0) node.full = true;
      return;
    default:
      return node.make_room();
  }
}

RC_GTEST_PROP(StaticPdoProperty, DoesOnTheBusWhatAWritableOneDoes, ()) {
  Static fixed;
  Writable writable;
  fixed.operate();
  writable.operate();
  const auto steps = *rc::gen::container<std::vector<std::pair<unsigned, unsigned>>>(
      200, rc::gen::pair(rc::gen::inRange(0U, 9U), rc::gen::inRange(0U, 300U)));
  for (const auto& [what, with] : steps) {
    live(fixed, what, with);
    live(writable, what, with);
    RC_ASSERT(fixed.sent == writable.sent);
    for (std::uint8_t sub = 1; sub <= 2; ++sub) {
      RC_ASSERT(fixed.number(0x2001, sub) == writable.number(0x2001, sub));
    }
    RC_ASSERT(fixed.number(0x2002, 0) == writable.number(0x2002, 0));
  }
}

}  // namespace
}  // namespace canvoy::pdo_static_test
