#include "canvoy/canopen/sync/time_stamp.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::time_stamp_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

// 1012h with the default of CiA 301: neither consumer nor producer.
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1012, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::rw, .initial = 0x100}}));
constexpr auto layout_consumer =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1012, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::rw, .initial = 0x8000'0100}}));

constexpr auto layout_of_29_bits =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1012, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::rw, .initial = 0xE000'0100}}));
constexpr auto layout_restricted =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1012, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::rw, .initial = 0xC000'0581}}));

constexpr std::uint32_t consume = 0x8000'0000;
constexpr std::uint32_t produce = 0x4000'0000;

// 12:00:00 on 21 November 2026, and a minute later.
constexpr TimeOfDay noon{.milliseconds = 43'200'000, .days = 15665};
constexpr auto noon_bytes = "00 2E 93 02 31 3D";
constexpr auto minute_later = "60 18 94 02 31 3D";

struct TimeNode : WireNode {
  explicit TimeNode(const DictionaryTables& tables = layout.tables(), NodeId id = 5)
      : WireNode(tables, id), sut(node) {
    sut.on_time(callback<&TimeNode::heard>(*this));
    boot();
  }

  AbortCode write(std::uint32_t value) {
    std::uint8_t bytes[4];
    store(bytes, value);
    node.advance(now);
    const AbortCode answer = node.dictionary().write(0x1012, 0, bytes, Source::sdo);
    settle();
    return answer;
  }
  /// Sets the clock to noon.
  void set_noon() {
    node.advance(now);
    EXPECT_TRUE(sut.set_clock(noon));
  }
  /// A producer with a clock set to noon.
  void make_producer() {
    EXPECT_EQ(write(produce | 0x100), none);
    set_noon();
  }
  void produce_each(Duration period) {
    node.advance(now);
    sut.produce_each(period);
  }
  bool send() {
    node.advance(now);
    return sut.send();
  }

  void heard(const TimeOfDay& time, Duration correction) {
    log.push_back(std::to_string(time.days) + " " + std::to_string(time.milliseconds) + " moved " +
                  std::to_string(correction / 1us));
  }
  Texts take() { return std::exchange(log, {}); }

  Texts log;
  TimeStamp sut;
};

std::string time_frame(const char* bytes) {
  return std::string("100#") + bytes;
}

// Consumer

TEST(TimeConsumer, HearsTimeWhereBit31Of1012hIsSet) {
  TimeNode node;
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take(), Texts());
  ASSERT_EQ(node.write(consume | 0x100), none);
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take(), Texts({"15665 43200000 moved 0"}));
  ASSERT_EQ(node.write(0x100), none);
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take(), Texts());
}

TEST(TimeConsumer, HearsItInPreOperationalAndOperational) {
  TimeNode node(layout_consumer.tables());
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take().size(), 1U) << "pre-operational";
  node.receive("000#01 00");
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take().size(), 1U) << "operational";
  node.receive("000#02 00");
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take().size(), 0U) << "stopped";
  node.receive("000#80 00");
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take().size(), 1U) << "pre-operational again";
}

TEST(TimeConsumer, DoesNotHearItWithoutANodeId) {
  TimeNode node(layout_consumer.tables(), node_id_unconfigured);
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take(), Texts());
}

TEST(TimeConsumer, SetsItsClockAndTellsHowFarItMoved) {
  TimeNode node(layout_consumer.tables());
  EXPECT_EQ(node.sut.clock(node.now), std::nullopt);
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.sut.clock(node.now), noon);
  node.run_for(59'990ms);
  node.receive(time_frame(minute_later));
  node.run_for(60'020ms);
  node.receive("100#C0 02 95 02 31 3D");  // another minute later
  EXPECT_EQ(node.take(), Texts({"15665 43200000 moved 0", "15665 43260000 moved 10000",
                                "15665 43320000 moved -20000"}));
  EXPECT_EQ(node.sut.clock(node.now), (TimeOfDay{.milliseconds = 43'320'000, .days = 15665}));
}

TEST(TimeConsumer, GoesOnCountingOverMidnight) {
  TimeNode node(layout_consumer.tables());
  node.receive("100#FF 5B 26 05 31 3D");  // 86,399,999 ms
  EXPECT_EQ(node.sut.clock(node.now + 999us),
            (TimeOfDay{.milliseconds = 86'399'999, .days = 15665}));
  EXPECT_EQ(node.sut.clock(node.now + 1ms), (TimeOfDay{.milliseconds = 0, .days = 15666}));
}

TEST(TimeConsumer, ShowsNothingAfterTheLastDayThatCanBeTold) {
  TimeNode node(layout_consumer.tables());
  node.receive("100#FF 5B 26 05 FF FF");
  EXPECT_NE(node.sut.clock(node.now), std::nullopt);
  EXPECT_EQ(node.sut.clock(node.now + 1ms), std::nullopt);
}

TEST(TimeConsumer, IgnoresTheFourReservedBits) {
  TimeNode node(layout_consumer.tables());
  node.receive("100#00 2E 93 F2 31 3D");
  EXPECT_EQ(node.take(), Texts({"15665 43200000 moved 0"}));
}

TEST(TimeConsumer, IgnoresAndCountsATimeOfAnotherLength) {
  TimeNode node(layout_consumer.tables());
  for (std::uint8_t length = 0; length <= 8; ++length) {
    Frame frame = wire_frame("100#00 2E 93 02 31 3D 00 00");
    frame.length = length;
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.take().size(), length == 6 ? 1U : 0U) << unsigned{length};
  }
  EXPECT_EQ(node.node.counters().malformed, 8U);
  EXPECT_EQ(node.sut.clock(node.now), noon);
}

TEST(TimeConsumer, IgnoresAndCountsATimeBeyondMidnight) {
  TimeNode node(layout_consumer.tables());
  node.receive("100#00 5C 26 05 31 3D");  // 86,400,000 ms
  node.receive("100#FF FF FF 0F 31 3D");
  EXPECT_EQ(node.take(), Texts());
  EXPECT_EQ(node.node.counters().malformed, 2U);
  EXPECT_EQ(node.sut.clock(node.now), std::nullopt);
}

TEST(TimeConsumer, TakesNoRemoteFrame) {
  TimeNode node(layout_consumer.tables());
  node.receive("100#R6");
  EXPECT_EQ(node.take(), Texts());
  node.expect({});
}

TEST(TimeConsumer, KeepsItsClockThroughResets) {
  TimeNode node(layout_consumer.tables());
  node.receive(time_frame(noon_bytes));
  node.receive("000#81 05");
  node.receive("000#82 05");
  EXPECT_EQ(node.sut.clock(node.now), noon);
}

// Producer

TEST(TimeProducer, TellsTheTimeEachPeriodWithoutDrift) {
  TimeNode node;
  node.make_producer();
  node.produce_each(60s);
  node.run_until(Time(59s));
  node.expect({});
  node.now = Time(60'005ms);  // called late
  node.settle();
  node.expect({"@60005000 100#65 18 94 02 31 3D"});
  node.run_until(Time(180s));
  node.expect({"@120000000 100#C0 02 95 02 31 3D", "@180000000 100#20 ED 95 02 31 3D"});
  node.produce_each(Duration::zero());
  node.run_until(Time(1h));
  node.expect({});
}

TEST(TimeProducer, LeavesOutThoseThatNobodyHadTimeFor) {
  TimeNode node;
  node.make_producer();
  node.produce_each(10s);
  node.now = Time(57s);
  node.settle();
  node.run_until(Time(70s));
  node.expect({"@57000000 100#A8 0C 94 02 31 3D", "@60000000 100#60 18 94 02 31 3D",
               "@70000000 100#70 3F 94 02 31 3D"});
}

TEST(TimeProducer, TellsTheTimeOnDemand) {
  TimeNode node;
  node.make_producer();
  node.run_until(Time(1min));
  EXPECT_TRUE(node.send());
  node.expect({"@60000000 100#60 18 94 02 31 3D"});
}

TEST(TimeProducer, IsSilentWithoutBit30Of1012h) {
  TimeNode node;
  node.set_noon();
  node.produce_each(1s);
  for (const std::uint32_t value : {0x100U, consume | 0x100U}) {
    ASSERT_EQ(node.write(value), none);
    EXPECT_FALSE(node.send());
    node.run_for(10s);
    node.expect({});
  }
  ASSERT_EQ(node.write(produce | 0x100), none);
  EXPECT_TRUE(node.send());
  node.run_for(1s);
  node.expect({"@20000000 100#20 7C 93 02 31 3D", "@21000000 100#08 80 93 02 31 3D"});
  ASSERT_EQ(node.write(0x100), none);
  node.run_for(10s);
  node.expect({});
}

TEST(TimeProducer, IsSilentWhileItHasNoClock) {
  TimeNode node;
  ASSERT_EQ(node.write(produce | 0x100), none);
  node.produce_each(1s);
  EXPECT_FALSE(node.send());
  node.run_for(10s);
  node.expect({});
  node.set_noon();
  node.run_for(1s);
  node.expect({"@11000000 100#E8 31 93 02 31 3D"});
}

TEST(TimeProducer, RefusesAClockBeyondMidnight) {
  TimeNode node;
  EXPECT_FALSE(node.sut.set_clock({.milliseconds = 86'400'000, .days = 1}));
  EXPECT_EQ(node.sut.clock(node.now), std::nullopt);
}

TEST(TimeProducer, SendsInPreOperationalAndOperationalOnly) {
  TimeNode node;
  node.make_producer();
  EXPECT_TRUE(node.send()) << "pre-operational";
  node.receive("000#01 00");
  EXPECT_TRUE(node.send()) << "operational";
  node.sent.clear();
  node.produce_each(1s);
  node.receive("000#02 00");
  EXPECT_FALSE(node.send()) << "stopped";
  node.run_for(10s);
  node.expect({});
  node.receive("000#80 00");
  node.run_for(1s);
  node.expect({"@11000000 100#F8 58 93 02 31 3D"});
}

TEST(TimeProducer, ReadsItsClockAnewWhenTheControllerHasRoomAgain) {
  TimeNode node;
  node.make_producer();
  node.full = true;
  node.node.transmitter().send(wire_frame("123#"));
  EXPECT_TRUE(node.send());
  node.now = Time(1min);
  node.full = false;
  node.node.tx_ready(node.now);
  node.expect({"@60000000 123#", "@60000000 100#60 18 94 02 31 3D"});
  node.node.tx_ready(node.now);
  node.expect({});
}

TEST(TimeProducer, WaitsUntilAllThatCameBeforeIsOnTheBus) {
  TimeNode node;
  node.make_producer();
  node.full = true;
  node.node.transmitter().send(wire_frame("123#"));
  node.node.transmitter().send(wire_frame("124#"));
  EXPECT_TRUE(node.send());
  node.on_sent = [&node](const Frame&) { node.full = true; };  // room for one frame at a time
  for (const char* frame : {"123#", "124#", "100#00 2E 93 02 31 3D"}) {
    node.full = false;
    node.node.tx_ready(node.now);
    node.expect({frame});
  }
}

TEST(TimeProducer, ForgetsWhatWaitsWhenItMayNoLongerSend) {
  for (const bool by_state : {false, true}) {
    TimeNode node;
    node.make_producer();
    node.full = true;
    node.node.transmitter().send(wire_frame("705#05"));
    EXPECT_TRUE(node.send());
    if (by_state) {
      node.receive("000#02 00");
    } else {
      ASSERT_EQ(node.write(0x100), none);
    }
    node.full = false;
    node.node.tx_ready(node.now);
    node.expect({"705#05"});
  }
}

TEST(TimeProducer, KeepsItsRhythmThroughAResetButIsWhat1012hSaysAgain) {
  TimeNode node;
  node.make_producer();
  node.produce_each(1s);
  node.receive("000#82 00");
  node.sent.clear();
  node.run_for(10s);
  node.expect({});
  ASSERT_EQ(node.write(produce | 0x100), none);
  node.run_for(1s);
  node.expect({"@11000000 100#F8 58 93 02 31 3D"});
}

TEST(TimeProducer, MayConsumeAsWell) {
  TimeNode node;
  ASSERT_EQ(node.write(consume | produce | 0x100), none);
  node.receive(time_frame(noon_bytes));
  node.run_for(1min);
  EXPECT_TRUE(node.send());
  node.expect({"@60000000 100#60 18 94 02 31 3D"});
}

// 1012h

TEST(TimeCobId, IsEveryCanIdThatIsNotRestricted) {
  TimeNode node;
  for (std::uint32_t can_id = 0; can_id <= 0x7FF; ++can_id) {
    const bool free = (can_id >= 0x080 && can_id <= 0x100) ||
                      (can_id >= 0x180 && can_id <= 0x580) || can_id == 0x600 ||
                      (can_id >= 0x680 && can_id <= 0x6DF) || can_id == 0x700;
    ASSERT_EQ(node.write(consume | can_id), free ? none : value_range) << can_id;
    if (!free) continue;
    node.node.receive(Frame::data_frame(can_id, {0, 0, 0, 0, 0, 0}), node.now);
    ASSERT_EQ(node.take().size(), 1U) << can_id;
    if (can_id == 0x080) continue;
    node.node.receive(Frame::data_frame(0x080, {0, 0, 0, 0, 0, 0}), node.now);
    ASSERT_EQ(node.take().size(), 0U) << can_id;
  }
}

TEST(TimeCobId, IsRefusedWith29Bits) {
  TimeNode node;
  for (unsigned bit = 11; bit <= 29; ++bit) {
    EXPECT_EQ(node.write(0x100U | 1U << bit), value_range) << bit;
  }
}

/// A data sheet may say what 1012h would refuse (CiA 301, 7.3.5: 581h is of SDO).
TEST(TimeCobId, OfADefaultThatIsRestrictedOrHas29BitsIsNotUsed) {
  for (const DictionaryTables& tables : {layout_of_29_bits.tables(), layout_restricted.tables()}) {
    TimeNode node(tables);
    node.receive(time_frame(noon_bytes));
    node.receive(std::string("581#") + noon_bytes);
    EXPECT_EQ(node.take(), Texts());
    node.set_noon();
    EXPECT_FALSE(node.send());
    node.expect({});
  }
}

TEST(TimeCobId, StaysWhileTimeIsProduced) {
  TimeNode node;
  ASSERT_EQ(node.write(produce | 0x100), none);
  for (std::uint32_t can_id = 0; can_id <= 0x7FF; ++can_id) {
    EXPECT_EQ(node.write(produce | can_id), can_id == 0x100 ? none : value_range) << can_id;
  }
  EXPECT_EQ(node.write(0x101), value_range) << "restricted";
  EXPECT_EQ(node.write(0x0C0), none) << "together with bit 30 it may change";
  EXPECT_EQ(node.write(produce | 0x0C1), none);
  node.set_noon();
  EXPECT_TRUE(node.send());
  node.expect({"0C1#00 2E 93 02 31 3D"});
}

TEST(TimeCobId, OfAConsumerIsRefusedWhereNoRouteIsLeft) {
  std::uint8_t values[4] = {};
  ObjectState states[1] = {};
  Router::Route routes[1];
  Frame backlog[1];
  constexpr auto tables = layout.tables();
  Node node(tables, {values, states, routes, backlog},
            {nullptr, [](void*, const Frame&) { return true; }, nullptr}, 5);
  TimeStamp sut(node);
  node.start(Time{});
  const std::uint8_t value[] = {0x00, 0x01, 0x00, 0x80};
  EXPECT_EQ(node.dictionary().write(0x1012, 0, value, Source::sdo), out_of_memory);
  const std::uint8_t producer[] = {0x00, 0x01, 0x00, 0x40};
  EXPECT_EQ(node.dictionary().write(0x1012, 0, producer, Source::sdo), none);
}

TEST(TimeCobId, HasItsDefaultAgainAfterAReset) {
  TimeNode node(layout_consumer.tables());
  ASSERT_EQ(node.write(0x0C0), none);
  node.receive("000#82 00");
  node.receive(time_frame(noon_bytes));
  EXPECT_EQ(node.take().size(), 1U);
}

// Golden frame: each flip of one of its bits is another time, or no TIME.
TEST(TimeConsumer, LivesThroughEverySingleBitFlipOfAGoodFrame) {
  for (unsigned bit = 0; bit < 48; ++bit) {
    TimeNode node(layout_consumer.tables());
    Frame frame = wire_frame(time_frame(noon_bytes));
    frame.data.at(bit / 8) ^= static_cast<std::uint8_t>(1U << bit % 8);
    node.node.receive(frame, node.now);
    const std::uint32_t milliseconds = 43'200'000U ^ (bit < 28 ? 1U << bit : 0U);
    const auto days = static_cast<std::uint16_t>(15665U ^ (bit >= 32 ? 1U << (bit - 32) : 0U));
    const bool good = milliseconds < 86'400'000;
    EXPECT_EQ(node.sut.clock(node.now),
              good ? std::optional(TimeOfDay{milliseconds, days}) : std::nullopt)
        << bit;
    EXPECT_EQ(node.node.counters().malformed, good ? 0U : 1U) << bit;
  }
}

}  // namespace
}  // namespace canvoy::time_stamp_test
