#include "canvoy/canopen/emergency/emergency_producer.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::emergency_producer_test {
namespace {

constexpr std::uint8_t history_depth = 3;

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1001, .entry_count = 1},
                                      {.index = 0x1003, .entry_count = 2},
                                      {.index = 0x1014, .entry_count = 1},
                                      {.index = 0x1015, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{},
                 {.access = Access::rw},
                 {.sub_first = 1, .sub_last = history_depth, .type = DataType::unsigned32},
                 {.type = DataType::unsigned32,
                  .access = Access::rw,
                  .traits = EntryTraits::plus_node_id,
                  .initial = 0x80},
                 {.type = DataType::unsigned16, .access = Access::rw}}));

constexpr auto layout_of_register_alone = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1001, .entry_count = 1}}), std::to_array<EntryRow>({{}}));

constexpr Error hot{.code = 0x4210, .register_bits = error_register::temperature};
constexpr Error high{.code = 0x3210, .register_bits = error_register::voltage};
constexpr Error lost{
    .code = 0x8130, .instance = 0x0A, .register_bits = error_register::communication};
constexpr Error detailed{
    .code = 0xFF01, .register_bits = error_register::manufacturer, .info = {1, 2, 3, 4, 5}};

struct EmergencyNode : WireNode {
  explicit EmergencyNode(const DictionaryTables& tables = layout.tables())
      : WireNode(tables, 5), producer(node, present, waiting) {
    boot();
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, unsigned length) {
    std::uint8_t bytes[4];
    store(bytes, value);
    node.advance(now);
    const AbortCode answer = node.dictionary().write(index, sub, {bytes, length}, Source::sdo);
    settle();
    return answer;
  }
  AbortCode write_cob_id(std::uint32_t value) { return write(0x1014, 0, value, 4); }
  /// Writes the inhibit time in multiples of 100 us.
  void write_inhibit(std::uint16_t value) {
    EXPECT_EQ(write(0x1015, 0, value, 2), AbortCode::none);
  }

  AbortCode read(std::uint16_t index, std::uint8_t sub) {
    const Result<Entry> entry = node.dictionary().find(index, sub);
    return entry ? node.dictionary().read(*entry).abort() : entry.abort();
  }
  std::uint64_t value(std::uint16_t index, std::uint8_t sub = 0) {
    return node.dictionary().number(index, sub);
  }

  Error present[4];
  Emergency waiting[4];
  EmergencyProducer producer;
};

TEST(EmergencyProducer, WithRoomForOneMessageTellsEachErrorAndWithNoneNoError) {
  for (const std::size_t room : {std::size_t{1}, std::size_t{0}}) {
    WireNode wire(layout.tables(), 5);
    Error present[2];
    Emergency waiting[1];
    EmergencyProducer sut(wire.node, present, std::span(waiting).first(room));
    wire.boot();
    wire.node.raise(hot);
    if (room == 0) {
      wire.expect({});
    } else {
      wire.expect({"085#10 42 09 00 00 00 00 00"});
    }
    EXPECT_EQ(wire.node.dictionary().number(0x1001, 0), 0x09u) << "the register tells either way";
  }
}

TEST(EmergencyProducer, TellsAnErrorThatComesAndOneThatGoes) {
  EmergencyNode sut;
  sut.node.raise(hot);
  sut.expect({"085#10 42 09 00 00 00 00 00"});
  sut.node.clear(hot);
  sut.expect({"085#00 00 00 00 00 00 00 00"});
}

TEST(EmergencyProducer, KeepsTheRegisterAsTheSumOfTheErrorsThatArePresent) {
  EmergencyNode sut;
  EXPECT_EQ(sut.value(0x1001), 0x00U);
  sut.node.raise(hot);
  EXPECT_EQ(sut.value(0x1001), 0x09U);
  sut.node.raise(high);
  EXPECT_EQ(sut.value(0x1001), 0x0DU);
  sut.node.raise(lost);
  EXPECT_EQ(sut.value(0x1001), 0x1DU);
  sut.node.clear(high);
  EXPECT_EQ(sut.value(0x1001), 0x19U);
  sut.node.clear(lost);
  sut.node.clear(hot);
  EXPECT_EQ(sut.value(0x1001), 0x00U);
  sut.expect({"085#10 42 09 00 00 00 00 00", "085#10 32 0D 00 00 00 00 00",
              "085#30 81 1D 0A 00 00 00 00", "085#00 00 19 00 00 00 00 00",
              "085#00 00 09 00 00 00 00 00", "085#00 00 00 00 00 00 00 00"});
}

TEST(EmergencyProducer, TellsEachErrorOnceWhereTheAnswerToOneRaisesAnother) {
  EmergencyNode sut;
  bool raised = false;
  sut.on_sent = [&](const Frame&) {
    if (!std::exchange(raised, true)) sut.node.raise(high);
  };
  sut.node.raise(hot);
  sut.expect({"085#10 42 09 00 00 00 00 00", "085#10 32 0D 00 00 00 00 00"});
}

TEST(EmergencyProducer, SetsTheGenericBitForAnyError) {
  for (unsigned bit = 0; bit < 8; ++bit) {
    EmergencyNode sut;
    sut.node.raise({.code = 0x1000, .register_bits = static_cast<std::uint8_t>(1U << bit)});
    EXPECT_EQ(sut.value(0x1001), (1U << bit) | 1U);
  }
}

TEST(EmergencyProducer, TellsTheManufacturerFieldOrElseTheInstance) {
  EmergencyNode sut;
  sut.node.raise(detailed);
  sut.node.raise({.code = 0x8250, .instance = 0x0123, .register_bits = 0x10});
  sut.expect({"085#01 FF 81 01 02 03 04 05", "085#50 82 91 23 01 00 00 00"});
}

TEST(EmergencyProducer, DoesNotTellAnErrorAgainWhileItIsPresent) {
  EmergencyNode sut;
  sut.node.raise(hot);
  sut.node.raise(hot);
  sut.expect({"085#10 42 09 00 00 00 00 00"});
  sut.node.clear(hot);
  sut.node.clear(hot);
  sut.expect({"085#00 00 00 00 00 00 00 00"});
  sut.node.raise(hot);
  sut.expect({"085#10 42 09 00 00 00 00 00"});
}

TEST(EmergencyProducer, TellsInstancesOfOneCodeApart) {
  EmergencyNode sut;
  Error other = lost;
  other.instance = 11;
  sut.node.raise(lost);
  sut.node.raise(other);
  sut.node.clear(lost);
  sut.expect({"085#30 81 11 0A 00 00 00 00", "085#30 81 11 0B 00 00 00 00",
              "085#00 00 11 00 00 00 00 00"});
  ASSERT_EQ(sut.producer.present().size(), 1U);
  EXPECT_EQ(sut.producer.present()[0].instance, 11);
}

TEST(EmergencyProducer, IgnoresAnErrorWithoutACodeAndTheEndOfOneThatNeverCame) {
  EmergencyNode sut;
  sut.node.raise({});
  sut.node.clear({});
  sut.node.clear(hot);
  sut.expect({});
  EXPECT_EQ(sut.value(0x1001), 0U);
}

TEST(EmergencyProducer, TellsAnErrorForWhichThereIsNoMemoryThoughItCannotKeepIt) {
  EmergencyNode sut;
  for (std::uint16_t instance = 0; instance < 4; ++instance) {
    sut.node.raise({.code = 0x5000, .instance = instance});
  }
  sut.sent.clear();
  sut.node.raise(hot);
  sut.expect({"085#10 42 09 00 00 00 00 00"});
  EXPECT_EQ(sut.value(0x1001), 0x01U);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0000'4210U);
  sut.node.clear(hot);
  sut.expect({});
}

TEST(EmergencyProducer, KeepsTheRegisterButTellsNothingWithout1014h) {
  EmergencyNode sut(layout_of_register_alone.tables());
  sut.node.raise(hot);
  EXPECT_EQ(sut.value(0x1001), 0x09U);
  sut.node.clear(hot);
  EXPECT_EQ(sut.value(0x1001), 0x00U);
  sut.expect({});
}

// 1003h

TEST(ErrorHistory, PutsTheNewestErrorFirstAndDropsTheOldest) {
  EmergencyNode sut;
  EXPECT_EQ(sut.value(0x1003, 0), 0U);
  sut.node.raise(hot);
  EXPECT_EQ(sut.value(0x1003, 0), 1U);
  sut.node.raise(lost);
  sut.node.raise(detailed);
  EXPECT_EQ(sut.value(0x1003, 0), 3U);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0201'FF01U);
  EXPECT_EQ(sut.value(0x1003, 2), 0x000A'8130U);
  EXPECT_EQ(sut.value(0x1003, 3), 0x0000'4210U);
  sut.node.raise(high);
  EXPECT_EQ(sut.value(0x1003, 0), 3U);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0000'3210U);
  EXPECT_EQ(sut.value(0x1003, 2), 0x0201'FF01U);
  EXPECT_EQ(sut.value(0x1003, 3), 0x000A'8130U);
}

TEST(ErrorHistory, KeepsErrorsThatAreGoneAndNotThatTheyWent) {
  EmergencyNode sut;
  sut.node.raise(hot);
  sut.node.clear(hot);
  EXPECT_EQ(sut.value(0x1003, 0), 1U);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0000'4210U);
}

TEST(ErrorHistory, HasNoDataBeyondTheNumberOfErrors) {
  EmergencyNode sut;
  EXPECT_EQ(sut.read(0x1003, 0), AbortCode::none);
  EXPECT_EQ(sut.read(0x1003, 1), AbortCode::no_data);
  sut.node.raise(hot);
  EXPECT_EQ(sut.read(0x1003, 1), AbortCode::none);
  EXPECT_EQ(sut.read(0x1003, 2), AbortCode::no_data);
  EXPECT_EQ(sut.read(0x1003, 3), AbortCode::no_data);
  EXPECT_EQ(sut.read(0x1003, 4), AbortCode::no_sub_index);
}

TEST(ErrorHistory, IsClearedBy0AndRefusesAllElse) {
  EmergencyNode sut;
  sut.node.raise(hot);
  for (std::uint32_t value = 1; value < 256; ++value) {
    EXPECT_EQ(sut.write(0x1003, 0, value, 1), AbortCode::value_range) << value;
  }
  EXPECT_EQ(sut.write(0x1003, 1, 0, 4), AbortCode::read_only);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0000'4210U);
  EXPECT_EQ(sut.write(0x1003, 0, 0, 1), AbortCode::none);
  EXPECT_EQ(sut.value(0x1003, 0), 0U);
  EXPECT_EQ(sut.value(0x1003, 1), 0U);
  EXPECT_EQ(sut.read(0x1003, 1), AbortCode::no_data);
  EXPECT_EQ(sut.value(0x1001), 0x09U) << "the error is present as before";
}

// 1014h

TEST(EmergencyCobId, Is080hAndTheNodeIdByDefaultAndMayBeChangedWhileInvalid) {
  EmergencyNode sut;
  EXPECT_EQ(sut.value(0x1014), 0x85U);
  EXPECT_EQ(sut.write_cob_id(0x0000'00C0), AbortCode::value_range);
  EXPECT_EQ(sut.write_cob_id(0x8000'0085), AbortCode::none);
  EXPECT_EQ(sut.write_cob_id(0x0000'00C0), AbortCode::none);
  sut.node.raise(hot);
  sut.expect({"0C0#10 42 09 00 00 00 00 00"});
  EXPECT_EQ(sut.write_cob_id(0x0000'00C0), AbortCode::none) << "the same again";
  EXPECT_EQ(sut.write_cob_id(0x8000'0123), AbortCode::none) << "invalid, with any CAN-ID";
}

TEST(EmergencyCobId, Refuses29BitsAndWhatIsReserved) {
  EmergencyNode sut;
  for (unsigned bit = 11; bit <= 30; ++bit) {
    EXPECT_EQ(sut.write_cob_id(0x0000'0085 | 1U << bit), AbortCode::value_range) << bit;
    EXPECT_EQ(sut.write_cob_id(0x8000'0085 | 1U << bit), AbortCode::value_range) << bit;
  }
}

TEST(EmergencyCobId, RefusesTheRestrictedCanIdsAndTakesAllOthers) {
  const auto restricted = [](std::uint32_t id) {
    return id <= 0x07F || (id >= 0x101 && id <= 0x17F) || (id >= 0x581 && id <= 0x5FF) ||
           (id >= 0x601 && id <= 0x67F) || (id >= 0x6E0 && id <= 0x6FF) || id >= 0x701;
  };
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    EmergencyNode sut;
    ASSERT_EQ(sut.write_cob_id(0x8000'0000), AbortCode::none);
    EXPECT_EQ(sut.write_cob_id(id), restricted(id) ? AbortCode::value_range : AbortCode::none)
        << std::hex << id;
  }
}

TEST(EmergencyCobId, SilencesTheProducerWhileItIsInvalid) {
  EmergencyNode sut;
  ASSERT_EQ(sut.write_cob_id(0x8000'0085), AbortCode::none);
  sut.node.raise(hot);
  EXPECT_EQ(sut.value(0x1001), 0x09U);
  EXPECT_EQ(sut.value(0x1003, 1), 0x0000'4210U);
  ASSERT_EQ(sut.write_cob_id(0x0000'0085), AbortCode::none);
  sut.expect({});
  sut.node.clear(hot);
  sut.expect({"085#00 00 00 00 00 00 00 00"});
}

TEST(EmergencyCobId, DropsWhatWaitsWhenItBecomesInvalid) {
  EmergencyNode sut;
  sut.write_inhibit(100);
  sut.node.raise(hot);
  sut.node.raise(high);
  sut.sent.clear();
  ASSERT_EQ(sut.write_cob_id(0x8000'0085), AbortCode::none);
  ASSERT_EQ(sut.write_cob_id(0x0000'0085), AbortCode::none);
  sut.run_for(1s);
  sut.expect({});
}

// 1015h

TEST(EmergencyInhibitTime, KeepsMessagesApartInTheirOrder) {
  EmergencyNode sut;
  sut.write_inhibit(25);
  sut.node.raise(hot);
  sut.node.raise(high);
  sut.node.clear(hot);
  sut.run_for(10ms);
  sut.expect({"@0 085#10 42 09 00 00 00 00 00", "@2500 085#10 32 0D 00 00 00 00 00",
              "@5000 085#00 00 05 00 00 00 00 00"});
  sut.node.advance(sut.now);
  sut.node.clear(high);
  sut.expect({"@10000 085#00 00 00 00 00 00 00 00"});
}

TEST(EmergencyInhibitTime, HoldsFromTheMomentItIsWritten) {
  EmergencyNode sut;
  sut.write_inhibit(65535);
  sut.node.raise(hot);
  sut.node.raise(high);
  sut.run_until(Time(1s));
  sut.expect({"@0 085#10 42 09 00 00 00 00 00"});
  sut.write_inhibit(11000);
  sut.run_until(Time(2s));
  sut.expect({"@1100000 085#10 32 0D 00 00 00 00 00"});
  sut.node.advance(sut.now);
  sut.node.raise(detailed);
  sut.node.raise(lost);
  sut.run_until(Time(3s));
  sut.expect({"@2200000 085#01 FF 8D 01 02 03 04 05"});
}

TEST(EmergencyInhibitTime, EndsTheWaitWhenItIsSetTo0) {
  EmergencyNode sut;
  sut.write_inhibit(65535);
  sut.node.raise(hot);
  sut.node.raise(high);
  sut.node.clear(high);
  sut.run_until(Time(5ms));
  sut.write_inhibit(0);
  sut.expect({"@0 085#10 42 09 00 00 00 00 00", "@5000 085#10 32 0D 00 00 00 00 00",
              "@5000 085#00 00 09 00 00 00 00 00"});
}

TEST(EmergencyInhibitTime, LosesNothingUpToTheBound) {
  EmergencyNode sut;
  sut.write_inhibit(10);
  sut.node.raise(detailed);
  for (int i = 0; i < 2; ++i) {
    sut.node.raise(hot);
    sut.node.clear(hot);
  }
  sut.run_for(1s);
  sut.expect({"@0 085#01 FF 81 01 02 03 04 05", "@1000 085#10 42 89 00 00 00 00 00",
              "@2000 085#00 00 81 00 00 00 00 00", "@3000 085#10 42 89 00 00 00 00 00",
              "@4000 085#00 00 81 00 00 00 00 00"});
  EXPECT_EQ(sut.producer.coalesced(), 0U);
}

TEST(EmergencyInhibitTime, ForgetsFirstThatAnErrorWentWhenTooManyMessagesWait) {
  EmergencyNode sut;
  sut.write_inhibit(10);
  sut.node.raise(detailed);  // at once
  sut.node.raise(hot);
  // Removed.
  sut.node.clear(hot);
  sut.node.raise(high);
  sut.node.raise(lost);
  sut.node.clear(high);
  sut.run_for(1s);
  sut.expect({"@0 085#01 FF 81 01 02 03 04 05", "@1000 085#10 42 89 00 00 00 00 00",
              "@2000 085#10 32 85 00 00 00 00 00", "@3000 085#30 81 95 0A 00 00 00 00",
              "@4000 085#00 00 91 00 00 00 00 00"});
  EXPECT_EQ(sut.producer.coalesced(), 1U);
}

TEST(EmergencyInhibitTime, AlwaysTellsTheLastRegisterAtLast) {
  EmergencyNode sut;
  sut.write_inhibit(10);
  for (std::uint16_t instance = 1; instance <= 4; ++instance) {
    sut.node.raise({.code = 0x8250, .instance = instance, .register_bits = 0x10});
  }
  sut.node.raise({.code = 0x8250, .instance = 9, .register_bits = 0x10});
  sut.node.clear({.code = 0x8250, .instance = 1});
  sut.node.clear({.code = 0x8250, .instance = 2});
  sut.node.clear({.code = 0x8250, .instance = 3});
  sut.node.clear({.code = 0x8250, .instance = 4});
  sut.run_for(1s);
  ASSERT_EQ(sut.sent.size(), 5U);
  EXPECT_EQ(wire_text(sut.sent[0].frame), "085#50 82 11 01 00 00 00 00");
  EXPECT_EQ(wire_text(sut.sent.back().frame), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(sut.producer.coalesced(), 4U);
}

// NMT states

TEST(EmergencyProducer, WaitsInStoppedUntilItMayTell) {
  EmergencyNode sut;
  sut.receive("000#02 05");
  sut.node.raise(hot);
  sut.node.raise(high);
  EXPECT_EQ(sut.value(0x1001), 0x0DU);
  sut.run_for(1s);
  sut.expect({});
  sut.receive("000#80 05");
  sut.expect({"@1000000 085#10 42 09 00 00 00 00 00", "@1000000 085#10 32 0D 00 00 00 00 00"});
  sut.receive("000#01 05");
  sut.node.clear(hot);
  sut.expect({"085#00 00 05 00 00 00 00 00"});
}

TEST(EmergencyProducer, TellsNothingBeforeTheBootUpMessage) {
  WireNode wire(layout.tables(), 5);
  Error present[4];
  Emergency waiting[4];
  EmergencyProducer sut(wire.node, present, waiting);
  Service device;
  struct Device {
    Node& node;
    void reset(ResetScope) { node.raise(hot); }
  } behaviour{wire.node};
  device.reset = callback<&Device::reset>(behaviour);
  wire.node.attach(device);
  wire.start();
  wire.expect({"705#00", "085#10 42 09 00 00 00 00 00"});
}

TEST(EmergencyProducer, ForgetsAllErrorsByResetNode) {
  EmergencyNode sut;
  sut.node.raise(hot);
  sut.node.raise(lost);
  sut.sent.clear();
  sut.receive("000#81 05");
  sut.expect({"705#00"});
  EXPECT_EQ(sut.value(0x1001), 0U);
  EXPECT_EQ(sut.value(0x1003, 0), 0U);
  EXPECT_TRUE(sut.producer.present().empty());
}

TEST(EmergencyProducer, TellsWhatIsWrongWithTheDeviceAgainAfterResetCommunication) {
  EmergencyNode sut;
  sut.node.raise(lost);
  sut.node.raise(hot);
  sut.node.raise(high);
  sut.sent.clear();
  sut.receive("000#82 05");
  sut.expect({"705#00", "085#10 42 09 00 00 00 00 00", "085#10 32 0D 00 00 00 00 00"});
  EXPECT_EQ(sut.value(0x1001), 0x0DU);
  EXPECT_EQ(sut.value(0x1003, 0), 2U);
}

TEST(EmergencyProducer, DropsWhatWaitsByAReset) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    EmergencyNode sut;
    sut.write_inhibit(1000);
    sut.node.raise(lost);
    sut.node.clear(lost);
    sut.sent.clear();
    sut.receive(reset);
    sut.run_for(10s);
    sut.expect({"@0 705#00"});
  }
}

// The bus

TEST(EmergencyProducer, TellsErrorPassiveAndItsEnd) {
  EmergencyNode sut;
  sut.node.bus_state(BusState::error_passive, sut.now);
  EXPECT_EQ(sut.value(0x1001), 0x11U);
  sut.node.bus_state(BusState::error_active, sut.now);
  sut.expect({"085#20 81 11 00 00 00 00 00", "085#00 00 00 00 00 00 00 00"});
}

TEST(EmergencyProducer, TellsNothingOfTheWarningLimitSinceCia301HasNoCodeForIt) {
  EmergencyNode sut;
  sut.node.bus_state(BusState::error_warning, sut.now);
  EXPECT_EQ(sut.value(0x1001), 0x00U);
  sut.expect({});
  sut.node.bus_state(BusState::error_passive, sut.now);
  sut.node.bus_state(BusState::error_warning, sut.now);
  sut.expect({"085#20 81 11 00 00 00 00 00", "085#00 00 00 00 00 00 00 00"});
  sut.node.bus_state(BusState::error_active, sut.now);
  sut.expect({});
}

TEST(EmergencyProducer, IsSilentInBusOffAndTellsOfItAfterTheRecovery) {
  EmergencyNode sut;
  sut.node.bus_state(BusState::error_passive, sut.now);
  sut.sent.clear();
  sut.node.bus_state(BusState::bus_off, sut.now);
  sut.node.raise(hot);
  sut.run_for(1s);
  sut.expect({});
  sut.node.bus_state(BusState::error_active, sut.now);
  sut.expect({"085#10 42 19 00 00 00 00 00", "085#40 81 19 00 00 00 00 00",
              "085#00 00 19 00 00 00 00 00", "085#00 00 09 00 00 00 00 00"});
  EXPECT_EQ(sut.value(0x1001), 0x09U);
}

TEST(EmergencyProducer, TellsErrorPassiveAgainAfterAResetWhileItLasts) {
  for (const char* reset : {"000#81 05", "000#82 05"}) {
    EmergencyNode sut;
    sut.node.bus_state(BusState::error_passive, sut.now);
    sut.sent.clear();
    sut.receive(reset);
    sut.expect({"705#00", "085#20 81 11 00 00 00 00 00"});
    sut.node.bus_state(BusState::error_active, sut.now);
    sut.expect({"085#00 00 00 00 00 00 00 00"});
  }
}

TEST(EmergencyProducer, TellsAnOverrunOnceAndItsEndASecondAfterTheLast) {
  EmergencyNode sut;
  sut.node.overrun(sut.now);
  sut.run_until(Time(600ms));
  sut.node.overrun(sut.now);
  sut.run_until(Time(10s));
  sut.expect({"@0 085#10 81 11 00 00 00 00 00", "@1600000 085#00 00 00 00 00 00 00 00"});
  sut.node.overrun(sut.now);
  sut.expect({"@10000000 085#10 81 11 00 00 00 00 00"});
}

TEST(EmergencyProducer, WaitsForRoomInAFullBacklog) {
  EmergencyNode sut;
  sut.full = true;
  for (std::uint8_t i = 0; i < 16; ++i) {
    sut.node.transmitter().send(Frame::data_frame(0x300, {i}));
  }
  sut.node.raise(hot);
  EXPECT_EQ(sut.node.transmitter().lost(), 0U);
  sut.full = false;
  sut.node.tx_ready(sut.now);
  ASSERT_EQ(sut.sent.size(), 17U);
  EXPECT_EQ(wire_text(sut.sent.back().frame), "085#10 42 09 00 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::emergency_producer_test
