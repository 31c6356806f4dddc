#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::rpdo_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

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
  EXPECT_EQ(node.write(0x1400, 1, 0x4000'0205), none) << "bit 30 is none of it";
  EXPECT_EQ(node.write(0x1400, 1, 0x6000'0205), value_range) << "bit 29 is";
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
  std::array<Router::Route, 1> routes;  // taken by NMT
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

/// Reserved transmission type of a dictionary, by default or from a memory.
struct ReservedType {
  void restore(ResetScope) { dictionary.set_number(0x1400, 2, 250); }
  Dictionary& dictionary;
};

TEST(Rpdo, WhoseTypeWasReservedByDefaultWorksWhenItGetsABetterOne) {
  PdoNode node;
  ReservedType defaults{node.node.dictionary()};
  node.node.on_defaults_restored(Callback<void(ResetScope)>::to<&ReservedType::restore>(defaults));
  for (const bool valid_first : {true, false}) {
    node.receive("000#82 00");
    ASSERT_EQ(node.write(0x1600, 0, 0), none);
    ASSERT_EQ(node.write(0x1600, 1, 0x2010'01'10), none);
    ASSERT_EQ(node.write(0x1600, 0, 1), none);
    if (!valid_first) {
      ASSERT_EQ(node.write(0x1400, 2, 255), none);
    }
    ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
    node.operate();
    node.receive("205#01 00");
    EXPECT_EQ(node.number(0x2010, 1), valid_first ? 0U : 1U);
    ASSERT_EQ(node.write(0x1400, 2, 255), none);
    node.receive("205#02 00");
    EXPECT_EQ(node.number(0x2010, 1), 2U);
    node.set(0x2010, 1, 0);
  }
}

TEST(Rpdo, IsReportedOnceBehindTheHooksOfItsValues) {
  PdoNode node;
  std::vector<std::string> log;
  auto written = [&log](const Entry& entry, Source) {
    log.push_back("value " + std::to_string(load_unsigned(entry.bytes())));
  };
  auto received = [&log](std::uint16_t number) { log.push_back("PDO " + std::to_string(number)); };
  Hook hook{.first = 0x2062, .last = 0x2062};
  hook.after_write = Callback<void(const Entry&, Source)>::of(written);
  node.node.dictionary().attach(hook);
  node.rpdos.received = Callback<void(std::uint16_t)>::of(received);
  node.map_rpdo(2, 0x305, 255, {0x2062'00'10});
  node.operate();
  node.receive("305#07 00");
  EXPECT_EQ(log, (std::vector<std::string>{"value 7", "PDO 2"}));
}

}  // namespace
}  // namespace canvoy::rpdo_test
