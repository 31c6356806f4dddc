#include "canvoy/canopen/rpdo.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

/// What no configurable communication object may use (CiA 301, 7.3.5), with 180h free for CiA 417.
bool is_free(unsigned can_id) {
  return (can_id >= 0x080 && can_id <= 0x100) || (can_id >= 0x180 && can_id <= 0x580) ||
         can_id == 0x600 || (can_id >= 0x680 && can_id <= 0x6DF) || can_id == 0x700;
}

TEST(Rpdo, IsReceivedOnEveryCanIdThatIsNotRestricted) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    ASSERT_EQ(node.write(0x1400, 1, CobId::bit31 | can_id), none) << can_id;
    ASSERT_EQ(node.write(0x1400, 1, can_id), is_free(can_id) ? none : value_range) << can_id;
    if (!is_free(can_id)) continue;
    Frame frame = Frame::data_frame(can_id, {0, 0});
    store(frame.data.data(), static_cast<std::uint16_t>(can_id ^ 0x5A5A));
    node.node.receive(frame, node.now);
    ASSERT_EQ(node.number(0x2010, 1), can_id ^ 0x5A5A);
  }
}

TEST(Rpdo, OnEveryCanIdThatIsRestrictedStaysInvalid) {
  PdoNode node;
  node.map_rpdo(1, 0x8000'0205, 255, {0x2010'01'10});
  node.operate();
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    if (is_free(can_id)) continue;
    EXPECT_EQ(node.write(0x1400, 1, can_id), value_range);
    EXPECT_EQ(node.number(0x1400, 1), 0x8000'0205U);
    EXPECT_FALSE(node.rpdos[1].is_active());
  }
}

TEST(Rpdo, ValidDoesNotChangeItsCanId) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    EXPECT_EQ(node.write(0x1400, 1, can_id), can_id == 0x205 ? none : value_range);
  }
  EXPECT_EQ(node.write(0x1400, 1, 0x4000'0205), value_range) << "bit 30 neither";
  node.receive("205#01 02");
  EXPECT_EQ(node.number(0x2010, 1), 0x0201U);
  EXPECT_EQ(node.write(0x1400, 1, 0x8000'0206), none) << "but with bit 31 it may";
  EXPECT_EQ(node.number(0x1400, 1), 0x8000'0206U);
}

TEST(Rpdo, With29BitsIsRefused) {
  PdoNode node;
  EXPECT_EQ(node.write(0x1400, 1, 0x2000'0205), value_range);
  EXPECT_EQ(node.write(0x1400, 1, 0xA000'0205), value_range);
  for (unsigned bit = 11; bit <= 29; ++bit) {
    EXPECT_EQ(node.write(0x1400, 1, 0x205U | 1U << bit), value_range) << bit;
    EXPECT_EQ(node.write(0x1400, 1, 0x8000'0205U | 1U << bit), value_range) << bit;
  }
}

TEST(Rpdo, HasTheTransmissionTypesThatAreNotReserved) {
  PdoNode node;
  for (unsigned type = 0; type <= 255; ++type) {
    const bool known = type <= 240 || type >= 254;
    EXPECT_EQ(node.write(0x1400, 2, type), known ? none : value_range) << type;
  }
}

TEST(Rpdo, OfTypes0To240IsTakenOverAtTheNextSyncAndOf254And255AtOnce) {
  for (unsigned type = 0; type <= 255; ++type) {
    if (type > 240 && type < 254) continue;
    PdoNode node;
    node.map_rpdo(1, 0x205, type, {0x2010'01'10});
    node.operate();
    node.receive("205#01 02");
    EXPECT_EQ(node.number(0x2010, 1), type <= 240 ? 0U : 0x0201U) << type;
    node.receive("080#");
    EXPECT_EQ(node.number(0x2010, 1), 0x0201U) << type;
  }
}

TEST(Rpdo, SynchronousTakesTheLastValuesOnceAndTheOldOnesNeverAgain) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
  node.set(0x2010, 1, 7);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 7U);
}

TEST(Rpdo, SynchronousForgetsWhatItHoldsWhenTheNodeLeavesOperational) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("000#80 00");
  node.operate();
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
}

TEST(Rpdo, ThatBecomesEventDrivenForgetsWhatItHolds) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  ASSERT_EQ(node.write(0x1400, 2, 255), none);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
  node.receive("205#02 00");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
}

TEST(Rpdo, ThatBecomesSynchronousWaitsForSync) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  for (int i = 0; i < 3; ++i) node.receive("205#01 00");
  ASSERT_EQ(node.write(0x1400, 2, 1), none);
  node.receive("205#02 00");
  EXPECT_EQ(node.number(0x2010, 1), 1U);
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 2U);
}

TEST(Rpdo, SynchronousComesTooLateBehindTheSynchronousWindow) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1007, 0, 2000), none);
  node.operate();
  node.run_until(Time(10ms));
  node.receive("080#");
  node.run_until(Time(12ms));
  node.receive("205#01 00");
  node.run_until(Time(12ms + 1us));
  node.receive("205#02 00");
  node.run_until(Time(20ms));
  node.receive("080#");
  EXPECT_EQ(node.number(0x2010, 1), 1U);
}

TEST(Rpdo, IsReceivedInOperationalOnly) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.receive("205#01 00");
  EXPECT_EQ(node.number(0x2010, 1), 0U) << "pre-operational";
  node.receive("000#02 00");
  node.receive("205#01 00");
  EXPECT_EQ(node.number(0x2010, 1), 0U) << "stopped";
  node.operate();
  node.receive("205#01 00");
  EXPECT_EQ(node.number(0x2010, 1), 1U) << "operational";
  node.receive("000#80 00");
  node.receive("205#02 00");
  EXPECT_EQ(node.number(0x2010, 1), 1U) << "pre-operational again";
}

TEST(Rpdo, IsNeitherARemoteNorA29BitFrame) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#R2");
  node.receive("00000205#01 00");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
  EXPECT_TRUE(node.errors().empty());
}

TEST(Rpdo, TooShortIsIgnoredAndAnErrorUntilAGoodOneComes) {
  for (std::size_t length = 0; length < 8; ++length) {
    PdoNode node;
    node.map_rpdo(3, 0x205, 255, {0x2020'01'20, 0x2020'02'20});
    node.operate();
    node.receive("205#11 11 11 11 22 22 22 22");
    Frame frame = wire_frame("205#33 33 33 33 44 44 44");
    frame.length = static_cast<std::uint8_t>(length);
    node.node.receive(frame, node.now);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.errors(), Texts({"+8210/3"}));
    EXPECT_EQ(node.number(0x2020, 1), 0x11111111U);
    EXPECT_EQ(node.number(0x2020, 2), 0x22222222U);
    EXPECT_EQ(node.last_error().register_bits, error_register::communication);
    node.receive("205#55 55 55 55 66 66 66 66");
    EXPECT_EQ(node.errors(), Texts({"-8210/3"}));
    EXPECT_EQ(node.number(0x2020, 2), 0x66666666U);
  }
}

TEST(Rpdo, TooLongIsTakenWithItsFirstBytesAndAnErrorUntilAGoodOneComes) {
  PdoNode node;
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 02 03");
  EXPECT_EQ(node.number(0x2010, 1), 0x0201U);
  node.receive("205#03 04 05 06 07 08 09 0A");
  EXPECT_EQ(node.number(0x2010, 1), 0x0403U);
  EXPECT_EQ(node.errors(), Texts({"+8220/2"}));
  node.receive("205#05");
  EXPECT_EQ(node.errors(), Texts({"-8220/2", "+8210/2"}));
  node.receive("205#07 08 09");
  EXPECT_EQ(node.errors(), Texts({"-8210/2", "+8220/2"}));
  node.receive("205#09 0A");
  EXPECT_EQ(node.errors(), Texts({"-8220/2"}));
  EXPECT_EQ(node.number(0x2010, 1), 0x0A09U);
}

TEST(Rpdo, OfAFewBitsHasTheBytesThatTheyNeed) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2030'01'01, 0x2030'02'01, 0x2040'06'07});
  node.operate();
  node.receive("205#FF");
  EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
  node.receive("205#FE 03");
  EXPECT_EQ(node.errors(), Texts({"-8210/1"}));
  EXPECT_EQ(node.number(0x2030, 1), 0U);
  EXPECT_EQ(node.number(0x2030, 2), 1U);
}

TEST(Rpdo, WithOneValueOutOfRangeWritesNoneAndRaisesAnError) {
  PdoNode node;
  node.map_rpdo(4, 0x205, 255, {0x2010'01'10, 0x2000'01'08, 0x2060'00'08});
  node.operate();
  node.receive("205#01 02 03 0A");
  EXPECT_EQ(node.number(0x2060, 0), 10U);
  for (unsigned value = 0; value <= 255; ++value) {
    const bool fits = (value >= 10 && value <= 20) || value == 255;
    node.set(0x2010, 1, 0x7777);
    Frame frame = wire_frame("205#11 22 33 00");
    frame.data[3] = static_cast<std::uint8_t>(value);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.number(0x2010, 1), fits ? 0x2211U : 0x7777U) << value;
    EXPECT_EQ(node.number(0x2060, 0) == value, fits) << value;
  }
  EXPECT_EQ(node.errors(), Texts({"+8200/4", "-8200/4", "+8200/4", "-8200/4"}));
}

TEST(Rpdo, RefusedNamesThePdoAndTheObject) {
  PdoNode node;
  node.map_rpdo(4, 0x205, 255, {0x2010'01'10, 0x2061'00'10});
  node.operate();
  node.receive("205#00 00 9C FF");
  EXPECT_TRUE(node.errors().empty()) << "-100 fits";
  node.receive("205#00 00 9B FF");
  EXPECT_EQ(node.errors(), Texts({"+8200/4"})) << "-101 does not";
  EXPECT_EQ(node.last_error().info, (std::array<std::uint8_t, 5>{0x04, 0x00, 0x61, 0x20, 0x00}));
}

/// A hook on 2062h that takes even numbers only, and notes what it sees.
struct EvenOnly {
  explicit EvenOnly(PdoNode& node) : node_(node) {
    hook_.first = hook_.last = 0x2062;
    hook_.before_write =
        Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::to<&EvenOnly::check>(
            *this);
    hook_.after_write = Callback<void(const Entry&, Source)>::to<&EvenOnly::written>(*this);
    node.node.dictionary().attach(hook_);
  }
  AbortCode check(const Entry&, std::span<const std::uint8_t> value) {
    return value[0] % 2 == 0 ? none : value_range;
  }
  void written(const Entry&, Source source) {
    EXPECT_EQ(source, Source::pdo);
    ++told;
    last_value_of_pdo = node_.number(0x2010, 1);
  }

  int told = 0;
  std::uint64_t last_value_of_pdo = 0;

 private:
  PdoNode& node_;
  Hook hook_;
};

TEST(Rpdo, AsksTheHooksOfAllValuesBeforeItWritesOne) {
  PdoNode node;
  EvenOnly even(node);
  node.map_rpdo(1, 0x205, 255, {0x2062'00'10, 0x2010'01'10});
  node.operate();
  node.receive("205#02 00 11 11");
  EXPECT_EQ(even.told, 1);
  EXPECT_EQ(even.last_value_of_pdo, 0x1111U) << "all values are written before a hook is told";
  node.receive("205#03 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 2U);
  EXPECT_EQ(node.number(0x2010, 1), 0x1111U);
  EXPECT_EQ(even.told, 1);
  EXPECT_EQ(node.errors(), Texts({"+8200/1"}));
}

TEST(Rpdo, KnowsAHookThatWasAttachedAfterTheMapping) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2062'00'10, 0x2010'01'10});
  node.operate();
  node.receive("205#01 00 11 11");
  node.receive("205#03 00 11 11");
  EXPECT_EQ(node.number(0x2062, 0), 3U);
  EvenOnly even(node);
  node.receive("205#05 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 3U);
  node.receive("205#06 00 22 22");
  EXPECT_EQ(node.number(0x2062, 0), 6U);
  EXPECT_EQ(even.told, 1);
}

TEST(Rpdo, SynchronousIsCheckedWhenItIsTakenOver) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10, 0x2060'00'08});
  node.operate();
  node.receive("205#01 00 63");
  EXPECT_TRUE(node.errors().empty());
  node.receive("080#");
  EXPECT_EQ(node.errors(), Texts({"+8200/1"}));
  EXPECT_EQ(node.number(0x2010, 1), 0U);
}

TEST(Rpdo, ThatDoesNotComeInTimeIsAnErrorUntilItComes) {
  PdoNode node;
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1401, 5, 100), none);
  node.operate();
  node.run_until(Time(1s));
  EXPECT_TRUE(node.errors().empty()) << "supervision begins with the first reception";
  node.receive("205#01 00");
  node.run_until(Time(1100ms - 1us));
  EXPECT_TRUE(node.errors().empty());
  node.run_until(Time(1100ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/2"}));
  node.run_until(Time(2s));
  EXPECT_TRUE(node.errors().empty()) << "told once";
  node.receive("205#02 00");
  EXPECT_EQ(node.errors(), Texts({"-8250/2"}));
  EXPECT_EQ(node.number(0x2010, 1), 2U);
  node.run_until(Time(2100ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/2"}));
}

TEST(Rpdo, ThatComesAgainAndAgainKeepsItsDeadlineAway) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  for (int i = 0; i < 20; ++i) {
    node.receive("205#01 00");
    node.run_for(99ms);
  }
  EXPECT_TRUE(node.errors().empty());
  node.run_for(1ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"})) << "100 ms after the last one";
}

TEST(Rpdo, TooShortDoesNotMeetTheDeadline) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.run_for(60ms);
  node.receive("205#01");
  EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
  node.run_for(40ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
  node.receive("205#01 00");
  EXPECT_EQ(node.errors(), Texts({"-8210/1", "-8250/1"}));
}

TEST(Rpdo, SynchronousMeetsItsDeadlineWhenItIsReceived) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.run_for(99ms);
  node.receive("205#01 00");
  node.run_for(99ms);
  EXPECT_TRUE(node.errors().empty());
  node.run_for(1ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, TimeOutsOfOneLeaveTheOthersAlone) {
  PdoNode node;
  for (unsigned pdo = 1; pdo <= 4; ++pdo) {
    node.map_rpdo(pdo, 0x200 + pdo, 255, {0x2000'01'08});
    ASSERT_EQ(node.write(static_cast<std::uint16_t>(0x13FF + pdo), 5, 100 * pdo), none);
  }
  node.operate();
  for (const char* frame : {"201#01", "202#01", "203#01", "204#01"}) node.receive(frame);
  node.run_until(Time(200ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1", "+8250/2"}));
  node.receive("201#01");
  EXPECT_EQ(node.errors(), Texts({"-8250/1"}));
  node.run_until(Time(400ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/3", "+8250/1", "+8250/4"}));
}

TEST(Rpdo, DeadlineEndsWithOperationalAndBeginsAnewWithAReception) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.receive("000#80 00");
  node.run_for(1s);
  node.operate();
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
  node.receive("205#01 00");
  node.run_for(100ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, DeadlineCanBeChangedWhileThePdoIsValid) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 1000), none);
  node.operate();
  node.receive("205#01 00");
  node.run_until(Time(500ms));
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.run_until(Time(600ms - 1us));
  EXPECT_TRUE(node.errors().empty());
  node.run_until(Time(600ms));
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
  ASSERT_EQ(node.write(0x1400, 5, 0), none);
  EXPECT_EQ(node.errors(), Texts({"-8250/1"})) << "without a deadline nothing is late";
}

TEST(Rpdo, ADeadlineThatIsSetLateSupervisesFromTheNextReception) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
  node.receive("205#03 00");
  node.run_for(100ms);
  EXPECT_EQ(node.errors(), Texts({"+8250/1"}));
}

TEST(Rpdo, MadeInvalidClearsItsErrorsAndItsDeadline) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01");
  node.receive("205#01 00 00");
  ASSERT_EQ(node.errors(), Texts({"+8210/1", "-8210/1", "+8220/1"}));
  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  EXPECT_EQ(node.errors(), Texts({"-8220/1"}));
  node.run_for(1s);
  EXPECT_TRUE(node.errors().empty());
}

TEST(Rpdo, TellsTheApplicationOfReceptionsAndTimeOuts) {
  PdoNode node;
  Texts told;
  auto received = [&](std::uint16_t number) {
    told.push_back("received " + std::to_string(number) + " with " +
                   std::to_string(node.number(0x2010, 1)));
  };
  auto timed_out = [&](std::uint16_t number) {
    told.push_back("timed out " + std::to_string(number));
  };
  node.rpdos[2].received = Callback<void(std::uint16_t)>::of(received);
  node.rpdos[2].timed_out = Callback<void(std::uint16_t)>::of(timed_out);
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1401, 5, 100), none);
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  node.receive("205#03");
  node.run_for(100ms);
  EXPECT_EQ(told, Texts({"received 2 with 1", "received 2 with 2", "timed out 2"}));
}

TEST(Rpdo, SynchronousTellsTheApplicationAtSync) {
  PdoNode node;
  int told = 0;
  auto received = [&](std::uint16_t) { ++told; };
  node.rpdos[1].received = Callback<void(std::uint16_t)>::of(received);
  node.map_rpdo(1, 0x205, 5, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  EXPECT_EQ(told, 0);
  node.receive("080#");
  EXPECT_EQ(told, 1);
}

TEST(Rpdo, IsAskedForByARemoteFrameWhereBit30AllowsIt) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10, 0x2000'01'08});
  node.map_rpdo(2, 0x4000'0305, 255, {0x2010'01'10});
  node.map_rpdo(3, 0x8000'0405, 255, {0x2010'01'10});
  EXPECT_FALSE(node.rpdos.request(1)) << "not in pre-operational";
  node.operate();
  EXPECT_TRUE(node.rpdos.request(1));
  EXPECT_FALSE(node.rpdos.request(2)) << "bit 30";
  EXPECT_FALSE(node.rpdos.request(3)) << "invalid";
  EXPECT_FALSE(node.rpdos.request(4)) << "not mapped";
  EXPECT_FALSE(node.rpdos.request(0));
  EXPECT_FALSE(node.rpdos.request(5));
  node.expect({"205#R3"});
}

TEST(Rpdo, TwoMayHaveOneCanId) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.map_rpdo(2, 0x205, 255, {0x2000'01'08, 0x2000'02'08});
  node.operate();
  node.receive("205#11 22");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U);
  EXPECT_EQ(node.number(0x2000, 2), 0x22U);
  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  node.receive("205#33 44");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U);
  EXPECT_EQ(node.number(0x2000, 2), 0x44U);
}

TEST(Rpdo, HasItsDefaultsAgainAfterAReset) {
  for (const char* reset : {"000#81 00", "000#82 05"}) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
    node.operate();
    node.receive("205#01 00");
    node.receive(reset);
    EXPECT_EQ(node.number(0x1400, 1), 0x8000'0000U);
    EXPECT_EQ(node.number(0x1600, 0), 0U);
    EXPECT_FALSE(node.rpdos[1].is_active());
    node.operate();
    node.receive("205#02 00");
    node.receive("080#");
    EXPECT_EQ(node.number(0x2010, 1), 0U);
  }
}

TEST(Rpdo, RaisesItsErrorAgainAfterAReset) {
  PdoNode node;
  for (int i = 0; i < 2; ++i) {
    node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
    node.operate();
    node.receive("205#01");
    EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
    node.receive("000#82 00");
  }
}

TEST(Rpdo, ThatArrivesInOneChangesATpdoAtOnce) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.expect({"185#01 00"});
  node.receive("205#01 00");
  node.expect({});
  node.receive("205#02 00");
  node.expect({"185#02 00"});
}

TEST(Rpdo, ThatWritesTwoObjectsByOneCopyChangesTheTpdoOfEither) {
  for (const std::uint32_t mapped : {0x2000'10'08U, 0x2010'01'10U}) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 255, {0x2000'10'08, 0x2010'01'10});
    node.map_tpdo(1, 0x185, 255, {mapped});
    node.operate();
    node.receive("205#01 02 03");
    node.expect({mapped == 0x2000'10'08U ? "185#01" : "185#02 03"});
    node.receive("205#04 05 06");
    node.expect({mapped == 0x2000'10'08U ? "185#04" : "185#05 06"});
  }
}

TEST(Rpdo, OfBitsChangesATpdoAtOnce) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2030'01'01, 0x2040'02'03});
  node.map_tpdo(1, 0x185, 255, {0x2040'02'03});
  node.operate();
  node.receive("205#0B");
  node.expect({"185#05"});
  node.receive("205#0A");
  node.expect({});
}

/// The error behaviour 1029h may end operational because of the very frame that is under way.
TEST(Rpdo, IsNotTakenWhereItsLengthErrorEndedOperational) {
  PdoNode node;
  Service service;
  auto stop = [&](const Error&, bool) { node.node.command(NmtCommand::enter_pre_operational); };
  service.error_changed = Callback<void(const Error&, bool)>::of(stop);
  node.node.attach(service);
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00 00");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
  EXPECT_FALSE(node.rpdos[1].is_supervised());
}

TEST(Rpdo, IsOffWhereItsObjectsAreAbsent) {
  constexpr static auto layout =
      lay_out(std::to_array<ObjectRow>({{.index = 0x2000, .entry_count = 1}}),
              std::to_array<EntryRow>({{.type = DataType::unsigned8}}));
  constexpr static DictionaryTables tables = layout.tables();
  WireNode wire(tables, 5);
  std::array<Rpdo, 2> pdos;
  std::array<MappedValue, 16> values;
  Rpdos rpdos(wire.node, pdos, values);
  wire.boot_operational();
  EXPECT_FALSE(rpdos[1].is_active());
  EXPECT_FALSE(rpdos.request(2));
}

TEST(Rpdo, WithoutMemoryForItsValuesRefusesTheirNumber) {
  WireNode wire(pdo_tables, 5);
  std::array<Rpdo, 2> pdos;
  std::array<MappedValue, 4> values;
  Rpdos rpdos(wire.node, pdos, values);
  wire.boot();
  Dictionary& dictionary = wire.node.dictionary();
  for (std::uint8_t sub = 1; sub <= 3; ++sub) {
    dictionary.set_number(0x1600, sub, 0x2000'00'08U + sub * 0x100U);
  }
  const auto write_count = [&](std::uint8_t count) {
    return dictionary.write(0x1600, 0, std::span(&count, 1), Source::sdo);
  };
  EXPECT_EQ(write_count(3), value_range);
  EXPECT_EQ(write_count(2), none);
}

TEST(Rpdo, IsRefusedWhereNoRouteIsLeft) {
  std::vector<std::uint8_t> bytes(pdo_tables.value_bytes);
  std::vector<ObjectState> states(pdo_tables.objects.size());
  std::array<Router::Route, 1> routes;  // NMT has it
  std::array<Frame, 4> backlog;
  const auto send = [](void*, const Frame&) { return true; };
  Node node(pdo_tables, {bytes, states, routes, backlog}, {nullptr, send, nullptr}, 5);
  std::array<Rpdo, 1> pdos;
  std::array<MappedValue, 8> values;
  Rpdos rpdos(node, pdos, values);
  node.start(Time{});
  std::array<std::uint8_t, 4> cob_id;
  store(cob_id.data(), std::uint32_t{0x205});
  EXPECT_EQ(node.dictionary().write(0x1400, 1, cob_id, Source::sdo), out_of_memory);
}

TEST(Rpdo, WorksFromItsDefaultsWhereTheyAreGood) {
  constexpr static auto layout =
      lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 2},
                                        {.index = 0x1600, .entry_count = 2},
                                        {.index = 0x2000, .entry_count = 1}}),
              std::to_array<EntryRow>({
                  {.sub_first = 1,
                   .sub_last = 1,
                   .type = DataType::unsigned32,
                   .access = Access::rw,
                   .traits = EntryTraits::plus_node_id,
                   .initial = 0x200},
                  parameter(2, DataType::unsigned8, 254),
                  parameter(0, DataType::unsigned8, 1),
                  parameter(1, DataType::unsigned32, 0x2000'00'08),
                  mappable(0, 0, DataType::unsigned8),
              }));
  constexpr static DictionaryTables tables = layout.tables();
  WireNode wire(tables, 0x11);
  std::array<Rpdo, 1> pdos;
  std::array<MappedValue, 8> values;
  Rpdos rpdos(wire.node, pdos, values);
  wire.boot_operational();
  wire.receive("211#2A");
  EXPECT_EQ(wire.node.dictionary().number(0x2000, 0), 0x2AU);
}

}  // namespace
}  // namespace canvoy
