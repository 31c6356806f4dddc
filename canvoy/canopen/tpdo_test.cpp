#include "canvoy/canopen/tpdo.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

constexpr Tpdos::AtStart send_at_start = Tpdos::AtStart::send;

/// What no configurable communication object may use (CiA 301, 7.3.5), with 180h free for CiA 417.
bool is_free(unsigned can_id) {
  return (can_id >= 0x080 && can_id <= 0x100) || (can_id >= 0x180 && can_id <= 0x580) ||
         can_id == 0x600 || (can_id >= 0x680 && can_id <= 0x6DF) || can_id == 0x700;
}

TEST(Tpdo, IsSentOnEveryCanIdThatIsNotRestricted) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    ASSERT_EQ(node.write(0x1800, 1, CobId::bit31 | can_id), none) << can_id;
    ASSERT_EQ(node.write(0x1800, 1, can_id), is_free(can_id) ? none : value_range) << can_id;
    node.sent.clear();
    node.set(0x2010, 1, can_id + 1);
    ASSERT_EQ(node.sent.size(), is_free(can_id) ? 1U : 0U) << can_id;
    if (is_free(can_id)) {
      ASSERT_EQ(node.sent[0].frame.id, can_id);
    }
  }
}

TEST(Tpdo, ValidDoesNotChangeItsCanIdNorBit30) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    EXPECT_EQ(node.write(0x1800, 1, can_id), can_id == 0x185 ? none : value_range);
  }
  EXPECT_EQ(node.write(0x1800, 1, 0x4000'0185), value_range);
  EXPECT_EQ(node.write(0x1800, 1, 0xC000'0186), none) << "but with bit 31 it may";
  EXPECT_EQ(node.write(0x1800, 1, 0x4000'0186), none);
}

TEST(Tpdo, With29BitsIsRefused) {
  PdoNode node;
  for (unsigned bit = 11; bit <= 29; ++bit) {
    EXPECT_EQ(node.write(0x1800, 1, 0x185U | 1U << bit), value_range) << bit;
    EXPECT_EQ(node.write(0x1800, 1, 0x8000'0185U | 1U << bit), value_range) << bit;
  }
}

TEST(Tpdo, HasTheTransmissionTypesThatAreNotReserved) {
  PdoNode node;
  for (unsigned type = 0; type <= 255; ++type) {
    const bool known = type <= 240 || type >= 252;
    EXPECT_EQ(node.write(0x1800, 2, type), known ? none : value_range) << type;
  }
}

// ---- synchronous ----

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

// ---- event-driven ----

TEST(Tpdo, OfTypes254And255IsSentWhenAValueChanges) {
  for (const unsigned type : {254U, 255U}) {
    PdoNode node;
    node.map_tpdo(1, 0x185, type, {0x2010'01'10, 0x2000'03'08});
    node.operate();
    node.expect({});
    node.run_until(Time(5ms));
    node.set(0x2010, 1, 0x1234);
    node.expect({"@5000 185#34 12 00"});
    node.set(0x2010, 1, 0x1234);
    node.set(0x2010, 2, 0x9999);
    node.set(0x2000, 4, 1);
    node.expect({});
    ASSERT_EQ(node.write(0x2000, 3, 7), none);
    node.expect({"@5000 185#34 12 07"});
    node.receive("080#");
    node.expect({});
  }
}

TEST(Tpdo, IsSentWhenTheApplicationWritesAndTheNodeIsCalled) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.node.dictionary().set_number(0x2010, 1, 5);
  EXPECT_LE(node.node.deadline(), node.now) << "the node wants to be called";
  node.node.advance(node.now);
  node.expect({"185#05 00"});
}

TEST(Tpdo, ChangesOfSeveralValuesAreOneFrame) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10, 0x2010'02'10});
  node.operate();
  node.node.dictionary().set_number(0x2010, 1, 1);
  node.node.dictionary().set_number(0x2010, 2, 2);
  node.settle();
  node.expect({"185#01 00 02 00"});
}

TEST(Tpdo, OneValueInSeveralIsSentInAll) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.map_tpdo(4, 0x485, 254, {0x2000'02'08, 0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 1);
  node.expect({"185#01", "485#00 01"});
  node.set(0x2000, 2, 2);
  node.expect({"285#02", "485#02 01"});
}

TEST(Tpdo, IsSentInOperationalOnly) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.set(0x2010, 1, 1);
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
  node.operate();
  node.set(0x2010, 1, 2);
  node.expect({"185#02 00"});
  node.receive("000#02 00");
  node.set(0x2010, 1, 3);
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
}

TEST(Tpdo, EventDrivenIsSentOnceWhenTheNodeBecomesOperational) {
  PdoNode node(send_at_start);
  node.set(0x2000, 1, 0x11);
  node.map_tpdo(1, 0x185, 254, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 253, {0x2000'01'08});
  node.map_tpdo(4, 0x485, 0, {0x2000'01'08});
  node.expect({});
  node.operate();
  node.expect({"185#11", "285#11"});
  node.receive("080#");
  node.expect({"485#11"});
  node.operate();
  node.expect({});
  node.receive("000#80 00");
  node.operate();
  node.expect({"185#11", "285#11"});
}

TEST(Tpdo, EventDrivenIsSentOnceWhenItBecomesValidInOperational) {
  PdoNode node(send_at_start);
  node.operate();
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.expect({"185#00"});
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.expect({});
}

TEST(Tpdo, WaitsForAnEventAtStartWhereThatIsAskedFor) {
  PdoNode node;
  node.set(0x2000, 1, 0x11);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 0x11);
  node.set(0x2000, 2, 0x99);
  node.expect({});
  node.set(0x2000, 1, 0x12);
  node.expect({"185#12"});
}

TEST(Tpdo, IsTriggeredByTheApplicationWithoutAChange) {
  PdoNode node;
  node.map_tpdo(2, 0x285, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 253, {0x2000'01'08});
  node.operate();
  EXPECT_TRUE(node.tpdos.trigger(2));
  node.expect({"285#00"});
  EXPECT_FALSE(node.tpdos.trigger(3)) << "its type knows no events";
  EXPECT_FALSE(node.tpdos.trigger(1)) << "not mapped";
  EXPECT_FALSE(node.tpdos.trigger(0));
  EXPECT_FALSE(node.tpdos.trigger(5));
  node.expect({});
}

// ---- inhibit time ----

TEST(Tpdo, AnEventWithinTheInhibitTimeIsSentWhenItIsOverWithTheValuesOfThen) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(50ms));
  node.set(0x2010, 1, 1);
  node.expect({"@50000 185#01 00"});
  node.run_until(Time(52ms));
  node.set(0x2010, 1, 2);
  node.run_until(Time(59ms));
  node.set(0x2010, 1, 3);
  node.run_until(Time(60ms - 1us));
  node.expect({});
  node.run_until(Time(1s));
  node.expect({"@60000 185#03 00"});
  node.set(0x2010, 1, 4);
  node.expect({"@1000000 185#04 00"});
}

TEST(Tpdo, TheInhibitTimeBeginsAnewWithEachTransmission) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  for (unsigned ms = 0; ms < 45; ++ms) {
    node.run_until(Time(std::chrono::milliseconds(ms)));
    node.set(0x2010, 1, ms + 1);
  }
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@10000 185#0A 00", "@20000 185#14 00", "@30000 185#1E 00",
               "@40000 185#28 00", "@50000 185#2D 00"});
}

TEST(Tpdo, AnEventWithinTheInhibitTimeIsSentThoughTheChangeWasTakenBack) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 2);
  node.set(0x2010, 1, 1);
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@10000 185#01 00"});
}

TEST(Tpdo, TriggersWithinTheInhibitTimeAreOneFrame) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 65535), none);
  node.map_tpdo(1, 0x185, 254, {0x2010'01'10});
  node.operate();
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(node.tpdos.trigger(1));
  node.run_until(Time(100s));
  node.expect({"@0 185#00 00", "@6553500 185#00 00"});
}

TEST(Tpdo, AnEventThatWaitsIsForgottenWhenOperationalEnds) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.set(0x2010, 1, 2);
  node.receive("000#80 00");
  node.run_until(Time(1s));
  node.expect({"185#01 00"});
  node.operate();
  node.run_until(Time(2s));
  node.expect({});
}

TEST(Tpdo, TheInhibitTimeBeginsAnewWithOperational) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.run_until(Time(1ms));
  node.set(0x2010, 1, 2);
  node.run_until(Time(2ms));
  node.receive("000#80 00");
  node.operate();
  node.run_until(Time(5ms));
  node.set(0x2010, 1, 3);
  node.run_until(Time(6ms));
  node.set(0x2010, 1, 4);
  node.run_until(Time(1s));
  node.expect({"@0 185#01 00", "@5000 185#03 00", "@15000 185#04 00"});
}

TEST(Tpdo, InhibitTimeAndSyncStartChangeOnlyWhileThePdoIsInvalid) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  EXPECT_EQ(node.write(0x1800, 3, 100), value_range);
  EXPECT_EQ(node.write(0x1800, 3, 0), none) << "no change";
  EXPECT_EQ(node.write(0x1800, 6, 1), value_range);
  EXPECT_EQ(node.write(0x1800, 6, 0), none) << "no change";
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(node.write(0x1800, 3, 100), none);
  for (unsigned value = 0; value <= 255; ++value) {
    EXPECT_EQ(node.write(0x1800, 6, value), value <= 240 ? none : value_range);
  }
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

// ---- event timer ----

TEST(Tpdo, IsSentWhenTheEventTimerExpires) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 254, {0x2010'01'10});
  node.run_until(Time(1s));
  node.expect({});
  node.operate();
  node.run_until(Time(1350ms));
  node.expect({"@1100000 185#00 00", "@1200000 185#00 00", "@1300000 185#00 00"});
  node.receive("000#80 00");
  node.run_until(Time(2s));
  node.expect({});
}

TEST(Tpdo, TheEventTimerBeginsAnewWithEachTransmission) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(70ms));
  node.set(0x2010, 1, 1);
  node.run_until(Time(300ms));
  node.expect({"@70000 185#01 00", "@170000 185#01 00", "@270000 185#01 00"});
}

TEST(Tpdo, TheEventTimerKeepsTheInhibitTime) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 3, 500), none);  // 50 ms
  ASSERT_EQ(node.write(0x1800, 5, 20), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(199ms));
  node.expect({"@20000 185#00 00", "@70000 185#00 00", "@120000 185#00 00", "@170000 185#00 00"});
}

TEST(Tpdo, TheEventTimerChangesAtOnce) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 1000), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.run_until(Time(500ms));
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.run_until(Time(750ms));
  node.expect({"@600000 185#00 00", "@700000 185#00 00"});
  ASSERT_EQ(node.write(0x1800, 5, 0), none);
  node.run_until(Time(5s));
  node.expect({});
  ASSERT_EQ(node.write(0x1800, 5, 10), none);
  node.run_until(Time(5s + 10ms));
  node.expect({"@5010000 185#00 00"});
}

TEST(Tpdo, TheEventTimerIsForTypes254And255Only) {
  for (unsigned type = 0; type <= 253; ++type) {
    if (type > 240 && type < 252) continue;
    PdoNode node;
    ASSERT_EQ(node.write(0x1800, 5, 10), none);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.run_until(Time(1s));
    node.expect({});
  }
}

// ---- remote frames ----

TEST(Tpdo, OfType252IsSampledAtSyncAndSentOnRequest) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 252, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.receive("080#");
  node.set(0x2010, 1, 2);
  node.expect({});
  node.receive("185#R2");
  node.expect({"185#01 00"});
  node.receive("080#");
  node.receive("185#R2");
  node.expect({"185#02 00"});
}

TEST(Tpdo, OfType252IsSampledOnRequestBeforeTheFirstSyncInOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 252, {0x2010'01'10});
  for (unsigned i = 1; i <= 2; ++i) {
    node.operate();
    node.set(0x2010, 1, i);
    node.receive("185#R2");
    node.expect({"185#0" + std::to_string(i) + " 00"});
    node.receive("000#80 00");
  }
}

TEST(Tpdo, OfType253IsSentOnRequestWithTheValuesOfNow) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 253, {0x2010'01'10});
  node.operate();
  node.set(0x2010, 1, 1);
  node.receive("080#");
  node.expect({});
  node.receive("185#R2");
  node.expect({"185#01 00"});
  node.receive("185#R0");
  node.expect({"185#01 00"});
}

TEST(Tpdo, OfTypes254And255IsSentOnRequestToo) {
  for (const unsigned type : {254U, 255U}) {
    PdoNode node;
    ASSERT_EQ(node.write(0x1800, 3, 100), none);
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.receive("185#R2");
    node.expect({"@0 185#00 00"});
    node.receive("185#R2");
    node.run_until(Time(1s));
    node.expect({"@10000 185#00 00"});
  }
}

TEST(Tpdo, OfTypes0To240IsSentOnRequestWithTheValuesOfTheLastSync) {
  for (unsigned type = 0; type <= 240; ++type) {
    PdoNode node;
    node.map_tpdo(1, 0x185, type, {0x2010'01'10});
    node.operate();
    node.set(0x2010, 1, 1);
    for (unsigned sync = 0; sync < std::max(type, 1U); ++sync) node.receive("080#");
    node.set(0x2010, 1, 2);
    node.expect({"185#01 00"});
    node.receive("185#R2");
    node.expect({"185#01 00"});
  }
}

TEST(Tpdo, OfEveryTypeIsSilentOnRequestWhereBit30Forbids) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 252) continue;
    PdoNode node;
    node.map_tpdo(1, 0x4000'0185, type, {0x2010'01'10});
    node.operate();
    node.receive("185#R2");
    node.expect({});
  }
}

TEST(Tpdo, IsSilentOnRequestOutsideOfOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 253, {0x2010'01'10});
  node.receive("185#R2");
  node.expect({});
  node.operate();
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.receive("185#R2");
  node.expect({});
}

// ---- what the application adds ----

TEST(Tpdo, AsksTheApplicationToRefreshBeforeItIsSampled) {
  PdoNode node;
  std::vector<std::uint16_t> asked;
  auto refresh = [&](std::uint16_t number) {
    asked.push_back(number);
    node.node.dictionary().set_number(0x2010, 1, 0x100U * asked.size());
  };
  node.tpdos.before_transmit = Callback<void(std::uint16_t)>::of(refresh);
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.map_tpdo(2, 0x285, 1, {0x2000'01'08});
  node.operate();
  node.run_until(Time(100ms));
  node.expect({"@100000 185#00 01"});
  node.receive("080#");
  node.expect({"@100000 285#00", "@100000 185#00 03"});
  EXPECT_EQ(asked, (std::vector<std::uint16_t>{1, 2, 1}));
}

TEST(Tpdo, LetsTheHooksOfItsValuesRefreshThem) {
  PdoNode node;
  unsigned count = 0;
  auto refresh = [&](const Entry& entry) {
    const std::array<std::uint8_t, 2> bytes = {static_cast<std::uint8_t>(++count), 0xAA};
    node.node.dictionary().set(entry, bytes);
    return none;
  };
  Hook hook{.first = 0x2062, .last = 0x2062};
  hook.before_read = Callback<AbortCode(const Entry&)>::of(refresh);
  node.map_tpdo(1, 0x185, 253, {0x2062'00'10});
  node.operate();
  node.node.dictionary().attach(hook);
  node.receive("185#R2");
  node.receive("185#R2");
  node.expect({"185#01 AA", "185#02 AA"});
}

// ---- a controller that is full ----

TEST(Tpdo, ThatFindsNoRoomIsSentLaterWithTheValuesOfThen) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(2, 0x285, 255, {0x2000'02'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 20; ++i) node.set(0x2000, 1, i);  // 16 of them fit into the backlog
  node.set(0x2000, 2, 1);
  node.set(0x2000, 1, 21);
  node.expect({});
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 18U);
  EXPECT_EQ(wire_text(node.sent[15].frame), "185#10");
  EXPECT_EQ(wire_text(node.sent[16].frame), "185#15") << "not the value of the 17th change";
  EXPECT_EQ(wire_text(node.sent[17].frame), "285#01");
  EXPECT_EQ(node.node.transmitter().lost(), 0U);
  node.node.tx_ready(node.now);
  EXPECT_EQ(node.sent.size(), 18U);
}

TEST(Tpdo, SynchronousThatFindsNoRoomIsSentLaterWithItsSample) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 17; ++i) {
    node.set(0x2000, 1, i);
    node.receive("080#");
  }
  node.set(0x2000, 1, 0x99);
  node.full = false;
  node.node.tx_ready(node.now);
  ASSERT_EQ(node.sent.size(), 17U);
  EXPECT_EQ(wire_text(node.sent[16].frame), "185#11");
}

TEST(Tpdo, ThatWaitsForRoomIsForgottenWhenItBecomesInvalid) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  node.full = true;
  for (unsigned i = 1; i <= 17; ++i) node.set(0x2000, 1, i);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.full = false;
  node.node.tx_ready(node.now);
  EXPECT_EQ(node.sent.size(), 16U);
}

// ---- its life ----

TEST(Tpdo, MadeInvalidIsSilent) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1800, 5, 100), none);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.operate();
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  node.set(0x2000, 1, 1);
  node.receive("185#R1");
  node.run_until(Time(1s));
  EXPECT_FALSE(node.tpdos.trigger(1));
  node.expect({});
}

TEST(Tpdo, WatchesItsValuesOnlyWhileItIsSentForEvents) {
  PdoNode node;
  const Result<Entry> entry = node.node.dictionary().find(0x2000, 1);
  node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
  node.map_tpdo(3, 0x385, 0, {0x2000'02'08});
  EXPECT_EQ(entry->state->watchers, 0b1010U);
  ASSERT_EQ(node.write(0x1802, 2, 1), none);
  EXPECT_EQ(entry->state->watchers, 0b0010U);
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(entry->state->watchers, 0U);
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.receive("000#82 00");
  EXPECT_EQ(entry->state->watchers, 0U);
}

TEST(Tpdo, ChangesItsTypeInOperational) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 1, {0x2000'01'08});
  node.operate();
  node.set(0x2000, 1, 1);
  node.expect({});
  ASSERT_EQ(node.write(0x1800, 2, 255), none);
  node.set(0x2000, 1, 2);
  node.expect({"185#02"});
  ASSERT_EQ(node.write(0x1800, 2, 2), none);
  node.set(0x2000, 1, 3);
  node.receive("080#");
  node.expect({});
  node.receive("080#");
  node.expect({"185#03"});
}

TEST(Tpdo, HasItsDefaultsAgainAfterAReset) {
  for (const char* reset : {"000#81 00", "000#82 05"}) {
    PdoNode node(send_at_start);
    ASSERT_EQ(node.write(0x1800, 5, 100), none);
    node.map_tpdo(1, 0x185, 255, {0x2000'01'08});
    node.operate();
    node.expect({"185#00"});
    node.receive(reset);
    node.expect({"705#00"});
    node.operate();
    node.set(0x2000, 1, 1);
    node.receive("185#R1");
    node.run_until(Time(1s));
    node.expect({});
  }
}

TEST(Tpdo, IsRefusedWhereNoRouteForItsRemoteFramesIsLeft) {
  std::vector<std::uint8_t> bytes(pdo_tables.value_bytes);
  std::vector<ObjectState> states(pdo_tables.objects.size());
  std::array<Router::Route, 1> routes;  // NMT has it
  std::array<Frame, 4> backlog;
  const auto send = [](void*, const Frame&) { return true; };
  Node node(pdo_tables, {bytes, states, routes, backlog}, {nullptr, send, nullptr}, 5);
  std::array<Tpdo, 1> pdos;
  std::array<MappedValue, 8> values;
  Tpdos tpdos(node, pdos, values);
  node.start(Time{});
  std::array<std::uint8_t, 4> cob_id;
  store(cob_id.data(), std::uint32_t{0x185});
  EXPECT_EQ(node.dictionary().write(0x1800, 1, cob_id, Source::sdo), out_of_memory);
  store(cob_id.data(), std::uint32_t{0x4000'0185});
  EXPECT_EQ(node.dictionary().write(0x1800, 1, cob_id, Source::sdo), none);
}

// ---- as many as CiA 301 knows ----

constexpr std::uint16_t all = 512;

constexpr auto full_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .count = all, .entry_count = 2},
                                      {.index = 0x1600, .count = all, .entry_count = 2},
                                      {.index = 0x1800, .count = all, .entry_count = 2},
                                      {.index = 0x1A00, .count = all, .entry_count = 2},
                                      {.index = 0x2000, .count = all, .entry_count = 1},
                                      {.index = 0x3000, .count = all, .entry_count = 1}}),
            std::to_array<EntryRow>({
                invalid_cob_id,
                parameter(2, DataType::unsigned8, 255),
                parameter(0, DataType::unsigned8),
                {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
                invalid_cob_id,
                parameter(2, DataType::unsigned8, 255),
                parameter(0, DataType::unsigned8),
                {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
                mappable(0, 0, DataType::unsigned16),
                mappable(0, 0, DataType::unsigned16),
            }));
constexpr DictionaryTables full_tables = full_layout.tables();

/// RPDO n to object 2000h + n, object 3000h + n to TPDO n; both on CAN-ID 180h + n, since nobody
/// else is on this bus.
struct FullNode : WireNode {
  FullNode() : WireNode(full_tables, 5) {
    boot();
    for (std::uint16_t i = 0; i < all; ++i) {
      const std::uint32_t cob_id = 0x4000'0181U + i;
      map(static_cast<std::uint16_t>(0x1400 + i), 0x2000U + i, cob_id);
      map(static_cast<std::uint16_t>(0x1800 + i), 0x3000U + i, cob_id);
    }
    receive("000#01 00");
  }
  void map(std::uint16_t parameters, std::uint32_t index, std::uint32_t cob_id) {
    const auto record = static_cast<std::uint16_t>(parameters + 0x200);
    write(record, 1, index << 16 | 0x10, 4);
    write(record, 0, 1, 1);
    write(parameters, 1, cob_id, 4);
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t size) {
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    ASSERT_EQ(node.dictionary().write(index, sub, std::span(bytes).first(size), Source::sdo), none);
  }

  std::vector<Rpdo> rpdo_memory = std::vector<Rpdo>(all);
  std::vector<Tpdo> tpdo_memory = std::vector<Tpdo>(all);
  std::vector<MappedValue> values = std::vector<MappedValue>(2U * all * 8);
  Rpdos rpdos{node, rpdo_memory, std::span(values).first(all * 8)};
  Tpdos tpdos{node, tpdo_memory, std::span(values).last(all * 8), nullptr,
              Tpdos::AtStart::wait_for_event};
};

TEST(Pdos, Of512InEachDirectionEachOneWorks) {
  FullNode node;
  node.expect({});
  for (std::uint16_t i = 0; i < all; ++i) {
    const auto low = static_cast<std::uint8_t>(i + 1);
    const auto high = static_cast<std::uint8_t>((i + 1) >> 8);
    node.node.receive(Frame::data_frame(0x181U + i, {low, high}), node.now);
  }
  for (std::uint16_t i = 0; i < all; ++i) {
    EXPECT_EQ(node.node.dictionary().number(static_cast<std::uint16_t>(0x2000 + i), 0), i + 1U);
  }
  node.expect({});
  for (std::uint16_t i = 0; i < all; ++i) {
    node.node.dictionary().set_number(static_cast<std::uint16_t>(0x3000 + i), 0, i + 1U);
    node.settle();
    ASSERT_EQ(node.sent.size(), 1U) << i;
    EXPECT_EQ(node.sent[0].frame.id, 0x181U + i);
    EXPECT_EQ(load<std::uint16_t>(node.sent[0].frame.data.data()), i + 1U);
    node.sent.clear();
  }
}

TEST(Pdos, ThatShareABitOfTheWatchersWorkOnWhereOneIsMadeInvalid) {
  FullNode node;
  // TPDOs 1 and 33 share a bit. The first gets an object that nobody else watches.
  node.write(0x1800, 1, 0xC000'0181, 4);
  node.write(0x1A00, 0, 0, 1);
  node.write(0x1A00, 1, 0x2000'00'10, 4);
  node.write(0x1A00, 0, 1, 1);
  node.write(0x1800, 1, 0x4000'0181, 4);
  node.write(0x1820, 1, 0xC000'01A1, 4);
  node.node.dictionary().set_number(0x2000, 0, 1);
  node.settle();
  node.expect({"181#01 00"});
  node.node.dictionary().set_number(0x3020, 0, 1);
  node.settle();
  node.expect({});
  node.node.dictionary().set_number(0x3040, 0, 1);
  node.settle();
  node.expect({"1C1#01 00"});
}

TEST(Pdos, Of512ThatChangeAtOnceEachOneIsSent) {
  FullNode node;
  for (std::uint16_t i = 0; i < all; ++i) {
    node.node.dictionary().set_number(static_cast<std::uint16_t>(0x3000 + i), 0, 1);
  }
  node.settle();
  EXPECT_EQ(node.sent.size(), all);
}

}  // namespace
}  // namespace canvoy
