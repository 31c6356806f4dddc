// Producer of multiplexed PDOs in source address mode, and its scanner lists, frame by frame (CiA
// 301, 7.2.3 and 7.5.2.39).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::mpdo_source_producer_test {
namespace {

using enum AbortCode;
constexpr unsigned source = 0xFE;
constexpr auto send_at_start = Tpdos::AtStart::send;

TEST(SamProducer, SendsAListedObjectThatHasChanged) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2010'03, 0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.expect({});
  node.run_until(Time(5ms));
  node.set(0x2010, 3, 0x1234);
  node.expect({"@5000 185#05 10 20 03 34 12 00 00"});
  node.set(0x2010, 3, 0x1234);
  node.set(0x2010, 2, 0x9999);
  node.set(0x2000, 2, 0x99);
  node.expect({});
  ASSERT_EQ(node.write(0x2000, 1, 7), none);
  node.expect({"@5000 185#05 00 20 01 07 00 00 00"});
}

TEST(SamProducer, SendsEverySizeUpToFourBytesWithZerosBehind) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2020'04, 0x01'2040'00, 0x01'2050'00, 0x01'2081'00});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.set(0x2020, 4, 0x84332211);
  node.set(0x2040, 0, 0x832211);
  node.set(0x2050, 0, 1);
  node.set(0x2081, 0, 0x8211);
  node.expect({"185#05 20 20 04 11 22 33 84", "185#05 40 20 00 11 22 83 00",
               "185#05 50 20 00 01 00 00 00", "185#05 81 20 00 11 82 00 00"});
}

/// The block size is in the uppermost byte; a known stack took it from another.
TEST(SamProducer, SendsTheSubIndicesOfABlock) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x03'2000'05});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  for (std::uint8_t sub = 1; sub <= 16; ++sub) node.set(0x2000, sub, 1);
  node.expect({"185#05 00 20 05 01 00 00 00", "185#05 00 20 06 01 00 00 00",
               "185#05 00 20 07 01 00 00 00"});
}

/// Half of a backlog of 16 is for other services.
TEST(SamProducer, WhatFindsNoRoomIsSentLaterWithTheValuesOfThen) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x10'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.full = true;
  for (std::uint8_t sub = 1; sub <= 12; ++sub) {
    ASSERT_TRUE(node.node.dictionary().set_number(0x2000, sub, 1));
  }
  node.settle();
  node.node.advance(node.now);
  node.set(0x2000, 12, 2);
  node.expect({});
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 12u);
  EXPECT_EQ(wire_text(node.sent[0].frame), "185#05 00 20 01 01 00 00 00");
  EXPECT_EQ(wire_text(node.sent[11].frame), "185#05 00 20 0C 02 00 00 00");
}

TEST(SamProducer, LeavesOutWhatABlockNamesAndNobodyHas) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0xFF'2090'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.set(0x2090, 1, 1);
  node.set(0x2090, 3, 3);
  node.expect({"185#05 90 20 01 01 00 00 00", "185#05 90 20 03 03 00 00 00"});
}

TEST(SamProducer, ReadsAllListsAndAsManyEntriesAsSubIndex0Says) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2000'01, 0, 0x01'2000'02});
  node.fill_list(0x1FA1, {0x01'2000'03, 0x01'2000'04});
  ASSERT_EQ(node.write(0x1FA1, 0, 1), none);
  node.use_tpdo(1, 0x185, source);
  node.operate();
  for (std::uint8_t sub = 1; sub <= 4; ++sub) node.set(0x2000, sub, sub);
  node.expect({"185#05 00 20 01 01 00 00 00", "185#05 00 20 02 02 00 00 00",
               "185#05 00 20 03 03 00 00 00"});
}

TEST(SamProducer, SendsChangesOfOneMomentInTheOrderOfTheLists) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2010'02, 0x01'2010'01, 0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.node.dictionary().set_number(0x2000, 1, 1);
  node.node.dictionary().set_number(0x2010, 1, 2);
  node.node.dictionary().set_number(0x2010, 2, 3);
  node.settle();
  node.expect({"185#05 10 20 02 03 00 00 00", "185#05 10 20 01 02 00 00 00",
               "185#05 00 20 01 01 00 00 00"});
}

TEST(SamProducer, KeepsTheInhibitTimeAndLosesNothing) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.fill_list(0x1FA0, {0x03'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  for (std::uint8_t sub = 1; sub <= 3; ++sub) node.set(0x2000, sub, 0x10U + sub);
  node.run_until(Time(5ms));
  node.set(0x2000, 3, 0x33);
  node.run_until(Time(1s));
  node.expect({"@0 185#05 00 20 01 11 00 00 00", "@10000 185#05 00 20 02 12 00 00 00",
               "@20000 185#05 00 20 03 33 00 00 00"});
}

TEST(SamProducer, SendsAChangeThatWasTakenBackWithinTheInhibitTime) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.fill_list(0x1FA0, {0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.set(0x2000, 1, 1);
  node.set(0x2000, 1, 2);
  node.set(0x2000, 1, 1);
  node.run_until(Time(1s));
  node.expect({"@0 185#05 00 20 01 01 00 00 00", "@10000 185#05 00 20 01 01 00 00 00"});
}

TEST(SamProducer, LetsNoObjectStarveAnother) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.fill_list(0x1FA0, {0x03'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  std::array<unsigned, 4> count{};
  for (unsigned ms = 1; ms <= 300; ++ms) {
    node.set(0x2000, 1, ms % 251);  // changes all the time
    if (ms % 50 == 0) node.set(0x2000, 2, ms / 50);
    if (ms % 50 == 0) node.set(0x2000, 3, ms / 50);
    node.run_until(Time(std::chrono::milliseconds(ms)));
  }
  for (const auto& sent : node.sent) ++count.at(sent.frame.data[3]);
  // From 0 to 300 ms; the sixth change of the third object must wait.
  EXPECT_EQ(count[2], 6U);
  EXPECT_EQ(count[3], 5U);
  EXPECT_EQ(node.sent.size(), 31U);
}

TEST(SamProducer, SendsAllObjectsForTheEventTimerAndTheApplication) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.run_until(Time(150ms));
  node.expect({"@100000 185#05 00 20 01 00 00 00 00", "@100000 185#05 00 20 02 00 00 00 00"});
  node.node.advance(node.now);
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.expect({"@150000 185#05 00 20 01 00 00 00 00", "@150000 185#05 00 20 02 00 00 00 00"});
  node.run_until(Time(249ms));
  node.expect({});
  node.run_until(Time(250ms));
  node.expect({"@250000 185#05 00 20 01 00 00 00 00", "@250000 185#05 00 20 02 00 00 00 00"});
}

TEST(SamProducer, SendsAllObjectsAtTheStartWhereEventDrivenPdosAreSentThen) {
  MpdoNode node(send_at_start);
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.expect({});
  node.operate();
  node.expect({"185#05 00 20 01 00 00 00 00", "185#05 00 20 02 00 00 00 00"});
  node.receive("000#80 00");
  node.set(0x2000, 1, 1);
  node.expect({});
  node.operate();
  node.expect({"185#05 00 20 01 01 00 00 00", "185#05 00 20 02 00 00 00 00"});
}

TEST(SamProducer, WaitsForAChangeAtTheStartWhereThatIsAskedFor) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.set(0x2000, 1, 1);
  node.operate();
  node.set(0x2000, 2, 2);
  node.expect({"185#05 00 20 02 02 00 00 00"});
}

TEST(SamProducer, ForgetsWhatWaitsWhenOperationalEnds) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.set(0x2000, 1, 1);
  node.set(0x2000, 2, 2);
  node.receive("000#80 00");
  node.operate();
  node.run_until(Time(1s));
  node.expect({"185#05 00 20 01 01 00 00 00"});
}

TEST(SamProducer, ThatFindsNoRoomSendsLaterWithTheValuesOfThen) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) node.set(0x2000, 1, i);  // 8 of them fit
  node.set(0x2000, 2, 2);
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 10U);
  EXPECT_EQ(wire_text(node.sent[7].frame), "185#05 00 20 01 08 00 00 00");
  EXPECT_EQ(wire_text(node.sent[8].frame), "185#05 00 20 02 02 00 00 00");
  EXPECT_EQ(wire_text(node.sent[9].frame), "185#05 00 20 01 14 00 00 00");
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
}

TEST(SamProducer, LetsTheApplicationAndHooksRefreshTheValue) {
  MpdoNode node;
  unsigned count = 0;
  auto refresh = [&](const Entry& entry) {
    const std::array<std::uint8_t, 1> bytes = {static_cast<std::uint8_t>(0x40 + ++count)};
    node.node.dictionary().set(entry, bytes);
    return none;
  };
  Hook hook{.first = 0x2090, .last = 0x2090};
  hook.before_read = Callback<AbortCode(const Entry&)>::of(refresh);
  node.node.dictionary().attach(hook);
  auto prepare = [&](std::uint16_t number) {
    EXPECT_EQ(number, 1);
    node.node.dictionary().set_number(0x2000, 1, 0x77);
  };
  node.tpdos.before_transmit = Callback<void(std::uint16_t)>::of(prepare);
  node.fill_list(0x1FA0, {0x01'2090'01, 0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.expect({"185#05 90 20 01 41 00 00 00", "185#05 00 20 01 77 00 00 00"});
}

TEST(SamProducer, DoesNotAnswerRemoteFrames) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.receive("185#R8");
  node.expect({});
}

TEST(SamProducer, IsOneTpdoOfANode) {
  MpdoNode node;
  node.use_tpdo(1, 0x185, source);
  ASSERT_EQ(node.write(0x1A01, 0, source), none);
  EXPECT_EQ(node.write(0x1801, 1, 0x285), parameter_incompatible);
  EXPECT_EQ(node.write(0x1801, 1, 0x8000'0285), none);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(node.write(0x1801, 1, 0x285), none) << "when the first is invalid";
}

TEST(SamProducer, IsEventDriven) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 252) continue;
    MpdoNode node;
    ASSERT_EQ(node.write(0x1800, 2, type), none);
    ASSERT_EQ(node.write(0x1A00, 0, source), none);
    EXPECT_EQ(node.write(0x1800, 1, 0x185), type >= 254 ? none : parameter_incompatible) << type;
    EXPECT_EQ(node.tpdos[1].is_active(), type >= 254);
  }
}

TEST(SamProducer, WorksBesidePlainTpdosThatMapTheSameObject) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  ASSERT_EQ(node.write(0x1A01, 1, 0x2000'01'08), none);
  ASSERT_EQ(node.write(0x1A01, 0, 1), none);
  ASSERT_EQ(node.write(0x1801, 1, 0x285), none);
  node.operate();
  node.set(0x2000, 1, 7);
  node.expect({"185#05 00 20 01 07 00 00 00", "285#07"});
  ASSERT_EQ(node.write(0x1801, 1, 0x8000'0285), none);
  node.set(0x2000, 1, 8);
  node.expect({"185#05 00 20 01 08 00 00 00"});
}

TEST(ScannerList, MayChangeWhileItsTpdoWorks) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  ASSERT_EQ(node.write(0x1FA0, 1, 0x01'2010'02), none);
  node.set(0x2000, 1, 1);
  node.expect({});
  node.set(0x2010, 2, 2);
  node.expect({"185#05 10 20 02 02 00 00 00"});
  ASSERT_EQ(node.write(0x1FA0, 0, 0), none);
  node.set(0x2010, 2, 3);
  EXPECT_TRUE(node.tpdos.trigger(1));
  node.expect({});
}

TEST(ScannerList, RefusesWhatNoMpdoCanCarry) {
  MpdoNode node;
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2FFF'00), no_object);
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2000'11), no_sub_index);
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2030'00), not_mappable) << "8 bytes";
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2070'00), not_mappable) << "a string";
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2080'00), not_mappable);
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2082'00), not_mappable) << "RPDO only";
  EXPECT_EQ(node.write(0x1FA0, 1, 0x01'2081'00), none);
  EXPECT_EQ(node.write(0x1FA0, 1, 0), none) << "an unused entry";
}

TEST(ScannerList, OfMoreObjectsThanThereIsRoomForIsRefused) {
  MpdoNode node;
  ASSERT_EQ(node.write(0x1FA0, 0, 4), none);
  EXPECT_EQ(node.write(0x1FA0, 1, 0x10'2000'01), none) << "16 objects";
  EXPECT_EQ(node.write(0x1FA0, 2, 0x08'2010'01), none) << "24 objects";
  EXPECT_EQ(node.write(0x1FA0, 3, 0x01'2020'01), out_of_memory);
  EXPECT_EQ(node.number(0x1FA0, 3), 0U);
  ASSERT_EQ(node.write(0x1FA0, 0, 2), none);
  EXPECT_EQ(node.write(0x1FA0, 3, 0x01'2020'01), none) << "does not count";
  EXPECT_EQ(node.write(0x1FA0, 0, 3), out_of_memory);
  node.use_tpdo(1, 0x185, source);
  node.operate();
  EXPECT_TRUE(node.tpdos.trigger(1));
  EXPECT_EQ(node.sent.size(), 24U);
}

TEST(ScannerList, HasItsDefaultsAgainAfterAReset) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x01'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.receive("000#82 05");
  node.expect({"705#00"});
  EXPECT_EQ(node.number(0x1FA0, 0), 0U);
  node.use_tpdo(2, 0x285, source);
  node.operate();
  node.set(0x2000, 1, 1);
  node.expect({});
}

/// A SAM consumer gets the objects in the lists of a SAM producer.
TEST(SamProducer, IsHeardByAConsumerThatDispatchesIt) {
  MpdoNode producer;
  MpdoNode consumer(Tpdos::AtStart::wait_for_event, 10);
  producer.fill_list(0x1FA0, {0x08'2010'01});
  producer.use_tpdo(1, 0x185, source);
  producer.operate();
  consumer.fill_list(0x1FD0, {0x04'2020'01'2010'03'05});
  consumer.use_rpdo(1, 0x185, source);
  consumer.operate();
  for (std::uint8_t sub = 1; sub <= 8; ++sub) producer.set(0x2010, sub, 0x1000U + sub);
  for (const auto& sent : producer.sent) consumer.receive(wire_text(sent.frame));
  for (std::uint8_t sub = 1; sub <= 4; ++sub) {
    EXPECT_EQ(consumer.number(0x2020, sub), 0x1002U + sub);
  }
  EXPECT_EQ(consumer.errors(), std::vector<std::string>());
}

TEST(SamProducer, MayLoseItsListsToAnAnswerThatComesAtOnce) {
  MpdoNode node;
  node.fill_list(0x1FA0, {0x02'2000'01});
  node.use_tpdo(1, 0x185, source);
  node.operate();
  node.on_sent = [&](const Frame&) { EXPECT_EQ(node.write(0x1FA0, 0, 0), none); };
  node.set(0x2000, 1, 7);
  node.set(0x2000, 1, 8);
  node.expect({"185#05 00 20 01 07 00 00 00"});
}

}  // namespace
}  // namespace canvoy::mpdo_source_producer_test
