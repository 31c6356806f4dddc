#include "canvoy/canopen/pdo/pdo_mapping.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::pdo_mapping_test {
namespace {

using enum AbortCode;

constexpr std::uint16_t rpdo_record = 0x1600;
constexpr std::uint16_t tpdo_record = 0x1A00;

TEST(PdoMapping, IsRefusedWhileThePdoIsValid) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    EXPECT_EQ(node.write(record, 0, 0), unsupported_access);
    EXPECT_EQ(node.write(record, 0, 1), unsupported_access);
    EXPECT_EQ(node.write(record, 1, 0x2010'02'10), unsupported_access);
    EXPECT_EQ(node.number(record, 0), 1U);
    EXPECT_EQ(node.number(record, 1), 0x2010'01'10U);
  }
}

TEST(PdoMapping, EntriesAreRefusedWhileSubIndex0IsNotZero) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    ASSERT_EQ(node.write(record, 1, 0x2010'01'10), none);
    ASSERT_EQ(node.write(record, 0, 1), none);
    EXPECT_EQ(node.write(record, 1, 0x2010'02'10), unsupported_access);
    EXPECT_EQ(node.write(record, 2, 0x2010'02'10), unsupported_access);
    EXPECT_EQ(node.write(record, 0, 0), none);
    EXPECT_EQ(node.write(record, 1, 0x2010'02'10), none);
  }
}

TEST(PdoMapping, OfAnAbsentObjectIsRefused) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    EXPECT_EQ(node.write(record, 1, 0x2FFF'00'08), no_object);
    EXPECT_EQ(node.write(record, 1, 0x0008'00'08), no_object);
    EXPECT_EQ(node.write(record, 1, 0x2000'11'08), no_sub_index);
    EXPECT_EQ(node.write(record, 1, 0x2000'00'08), no_sub_index);
    EXPECT_EQ(node.number(record, 1), 0U);
  }
}

TEST(PdoMapping, OfAnotherLengthThanTheObjectIsRefused) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    for (unsigned bits = 0; bits <= 255; ++bits) {
      EXPECT_EQ(node.write(record, 1, 0x2010'01'00U + bits), bits == 16 ? none : not_mappable);
      EXPECT_EQ(node.write(record, 1, 0x2030'01'00U + bits), bits == 1 ? none : not_mappable);
      EXPECT_EQ(node.write(record, 1, 0x2070'00'00U + bits), bits == 32 ? none : not_mappable);
    }
  }
}

TEST(PdoMapping, IsOpenToWhatTheAccessOfTheObjectAllows) {
  PdoNode node;
  constexpr std::uint32_t neither = 0x2080'00'10;
  constexpr std::uint32_t transmit_only = 0x2081'00'10;
  constexpr std::uint32_t receive_only = 0x2082'00'10;
  constexpr std::uint32_t domain = 0x2083'00'08;
  EXPECT_EQ(node.write(rpdo_record, 1, neither), not_mappable);
  EXPECT_EQ(node.write(rpdo_record, 1, transmit_only), not_mappable);
  EXPECT_EQ(node.write(rpdo_record, 1, receive_only), none);
  EXPECT_EQ(node.write(rpdo_record, 1, domain), not_mappable);
  EXPECT_EQ(node.write(tpdo_record, 1, neither), not_mappable);
  EXPECT_EQ(node.write(tpdo_record, 1, transmit_only), none);
  EXPECT_EQ(node.write(tpdo_record, 1, receive_only), not_mappable);
  EXPECT_EQ(node.write(tpdo_record, 1, domain), not_mappable);
}

TEST(PdoMapping, OfDummyEntriesIsForRpdosInTheLengthOfTheirType) {
  const std::map<unsigned, unsigned> bits_of_dummy = {{1, 1}, {2, 8},  {3, 16}, {4, 32},
                                                      {5, 8}, {6, 16}, {7, 32}};
  PdoNode node;
  for (const auto& [index, length] : bits_of_dummy) {
    for (unsigned bits = 0; bits <= 64; ++bits) {
      const std::uint32_t mapped = (index << 16) | bits;
      EXPECT_EQ(node.write(rpdo_record, 1, mapped), bits == length ? none : not_mappable);
      EXPECT_EQ(node.write(tpdo_record, 1, mapped), not_mappable);
    }
    EXPECT_EQ(node.write(rpdo_record, 1, (index << 16) | 0x100 | length), no_sub_index);
  }
}

TEST(PdoMapping, OfMoreThan64BitsIsRefusedWithTheNumberOfEntries) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    for (std::uint8_t sub = 1; sub <= 9; ++sub) {
      ASSERT_EQ(node.write(record, sub, 0x2000'00'08U + sub * 0x100U), none);
    }
    EXPECT_EQ(node.write(record, 0, 9), pdo_length);
    EXPECT_EQ(node.number(record, 0), 0U);
    EXPECT_EQ(node.write(record, 0, 8), none);
    EXPECT_EQ(node.write(record, 0, 0), none);
    ASSERT_EQ(node.write(record, 9, 0x2030'01'01), none);
    EXPECT_EQ(node.write(record, 0, 9), pdo_length) << "65 bits";
  }
}

TEST(PdoMapping, OfMoreEntriesThanThereAreIsRefused) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    for (std::uint8_t sub = 1; sub <= 64; ++sub) {
      ASSERT_EQ(node.write(record, sub, 0x2030'00'01U + sub * 0x100U), none);
    }
    for (unsigned count = 65; count <= 255; ++count) {
      EXPECT_EQ(node.write(record, 0, count), value_range) << count;
    }
    EXPECT_EQ(node.write(record, 65, 0x2030'01'01), no_sub_index);
    EXPECT_EQ(node.write(record, 0, 64), none);
  }
}

TEST(PdoMapping, OfAnEmptiedEntryIsRefusedOnlyWhenItCounts) {
  PdoNode node;
  for (const std::uint16_t record : {rpdo_record, tpdo_record}) {
    ASSERT_EQ(node.write(record, 1, 0x2010'01'10), none);
    EXPECT_EQ(node.write(record, 2, 0), none);
    EXPECT_EQ(node.write(record, 0, 2), no_object);
    EXPECT_EQ(node.write(record, 0, 1), none);
  }
}

TEST(PdoMapping, CanBeChangedInOperationalByTheProcedure) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#11 22");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U);

  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  node.receive("205#33 44");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U) << "an invalid PDO is not received";
  ASSERT_EQ(node.write(rpdo_record, 0, 0), none);
  ASSERT_EQ(node.write(rpdo_record, 1, 0x2000'03'08), none);
  ASSERT_EQ(node.write(rpdo_record, 2, 0x2010'02'10), none);
  ASSERT_EQ(node.write(rpdo_record, 0, 2), none);
  ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
  node.receive("205#55 66 77");
  EXPECT_EQ(node.number(0x2010, 1), 0x2211U);
  EXPECT_EQ(node.number(0x2000, 3), 0x55U);
  EXPECT_EQ(node.number(0x2010, 2), 0x7766U);
}

TEST(PdoMapping, ARefusedNumberOfEntriesLeavesTheOldMapping) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10, 0x2010'02'10});
  node.operate();
  ASSERT_EQ(node.write(0x1400, 1, 0x8000'0205), none);
  EXPECT_EQ(node.write(rpdo_record, 0, 65), value_range);
  EXPECT_EQ(node.number(rpdo_record, 0), 2U);
  ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
  node.receive("205#01 02 03 04");
  EXPECT_EQ(node.number(0x2010, 1), 0x0201U);
  EXPECT_EQ(node.number(0x2010, 2), 0x0403U);
}

TEST(PdoMapping, WithoutEntriesIsNoPdo) {
  PdoNode node(Tpdos::AtStart::send);
  node.map_rpdo(1, 0x205, 255, {});
  node.map_tpdo(1, 0x185, 255, {});
  EXPECT_FALSE(node.rpdos[1].is_active());
  EXPECT_FALSE(node.tpdos[1].is_active());
  node.operate();
  node.receive("205#");
  node.expect({});
  EXPECT_TRUE(node.errors().empty());
}

/// The first PDO prepares the fast path of the next ones.
std::string zeros(std::size_t length) {
  std::string text;
  for (std::size_t i = 0; i < length; ++i) text += "00";
  return text;
}

/// Every type of one length is transferred both ways as its bytes, least significant first.
TEST(PdoMapping, CarriesEveryDataType) {
  struct Case {
    std::uint32_t mapped;
    const char* data;
    std::uint64_t value;
  };
  const std::vector<Case> cases = {
      {0x2050'01'08, "FE", 0xFE},
      {0x2050'02'18, "01 02 83", 0x830201},
      {0x2050'03'18, "01 02 83", 0x830201},
      {0x2050'04'28, "01 02 03 04 85", 0x8504030201},
      {0x2050'05'30, "01 02 03 04 05 86", 0x860504030201},
      {0x2050'06'38, "01 02 03 04 05 06 87", 0x87060504030201},
      {0x2050'07'40, "01 02 03 04 05 06 07 88", 0x8807060504030201},
      {0x2050'08'20, "00 00 80 3F", 0x3F800000},
      {0x2050'09'40, "00 00 00 00 00 00 F0 3F", 0x3FF0000000000000},
      {0x2050'0A'30, "10 32 54 06 11 22", 0x221106543210},
      {0x2050'0B'10, "FF 80", 0x80FF},
      {0x2050'0C'38, "01 02 03 04 05 06 87", 0x87060504030201},
      {0x2020'01'20, "01 02 03 84", 0x84030201},
  };
  for (const Case& c : cases) {
    PdoNode node(Tpdos::AtStart::wait_for_event);
    const auto index = static_cast<std::uint16_t>(c.mapped >> 16);
    const auto sub = static_cast<std::uint8_t>(c.mapped >> 8);
    node.map_rpdo(1, 0x205, 255, {c.mapped});
    node.map_tpdo(1, 0x185, 255, {c.mapped});
    node.operate();
    node.receive("205#" + zeros(std::string(c.data).size() / 3 + 1));
    node.expect({});
    node.receive("205#" + std::string(c.data));
    EXPECT_EQ(node.number(index, sub), c.value) << c.data;
    node.expect({"185#" + std::string(c.data)});
    ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
    for (int i = 0; i < 2; ++i) node.receive("205#" + zeros(std::string(c.data).size() / 3 + 1));
    EXPECT_EQ(node.number(index, sub), 0U);
    node.receive("205#" + std::string(c.data));
    EXPECT_EQ(node.number(index, sub), c.value) << c.data << ", when nobody watches it";
  }
}

TEST(PdoMapping, CarriesAStringOfAtMost8Characters) {
  PdoNode node;
  EXPECT_EQ(node.write(rpdo_record, 1, 0x2071'00'48), none) << "9 characters are mappable alone,";
  EXPECT_EQ(node.write(rpdo_record, 0, 1), pdo_length) << "but do not fit";
  node.map_rpdo(1, 0x205, 255, {0x2070'00'20});
  node.map_tpdo(1, 0x185, 255, {0x2070'00'20});
  node.operate();
  node.receive("205#61 62 63 64");
  node.expect({"185#61 62 63 64"});
  const Result<Entry> entry = node.node.dictionary().find(0x2070, 0);
  const std::array<std::uint8_t, 1> text = {'x'};
  node.node.dictionary().set(*entry, text);
  node.settle();
  node.expect({"185#78 00 00 00"});
}

TEST(PdoMapping, OfBooleansIsOneBitEachAndAnyNonZeroByteIsTrue) {
  PdoNode node;
  node.map_tpdo(1, 0x185, 255, {0x2030'01'01, 0x2030'02'01, 0x2030'03'01});
  node.operate();
  node.set(0x2030, 1, 0x02);
  node.expect({"185#01"});
  node.set(0x2030, 3, 0x80);
  node.expect({"185#05"});
}

TEST(PdoMapping, Carries64ValuesOfOneBitInBothDirections) {
  std::vector<std::uint32_t> bits;
  for (std::uint32_t sub = 1; sub <= 64; ++sub) bits.push_back(0x2030'00'01 + (sub << 8));
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, bits);
  node.map_tpdo(1, 0x185, 255, bits);
  node.operate();
  node.receive("205#01 02 04 08 10 20 40 80");
  node.expect({"185#01 02 04 08 10 20 40 80"});
  for (std::uint8_t sub = 1; sub <= 64; ++sub) {
    EXPECT_EQ(node.number(0x2030, sub), (sub - 1) / 8 == (sub - 1) % 8 ? 1U : 0U) << int{sub};
  }
}

TEST(PdoMapping, DummiesSkipBitsAndBytes) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x0005'00'08, 0x2010'01'10, 0x0003'00'10, 0x2000'01'08});
  node.map_rpdo(2, 0x305, 255, {0x0001'00'01, 0x2030'01'01, 0x0001'00'01, 0x2030'02'01});
  node.operate();
  node.receive("205#11 22 33 44 55 66");
  EXPECT_EQ(node.number(0x2010, 1), 0x3322U);
  EXPECT_EQ(node.number(0x2000, 1), 0x66U);
  node.map_rpdo(3, 0x405, 255, {0x2000'04'08, 0x0005'00'08, 0x2000'05'08});
  for (int i = 0; i < 2; ++i) {
    node.receive("405#04 99 05");
    EXPECT_EQ(node.number(0x2000, 4), 4U);
    EXPECT_EQ(node.number(0x2000, 5), 5U) << "side by side in the dictionary, not in the PDO";
  }
  node.receive("305#05");
  EXPECT_EQ(node.number(0x2030, 1), 0U);
  EXPECT_EQ(node.number(0x2030, 2), 0U);
  node.receive("305#0A");
  EXPECT_EQ(node.number(0x2030, 1), 1U);
  EXPECT_EQ(node.number(0x2030, 2), 1U);
}

TEST(PdoMapping, WritesNothingBesideTheMappedValues) {
  PdoNode node;
  for (std::uint8_t sub = 1; sub <= 16; ++sub) node.set(0x2000, sub, 0xA0U + sub);
  node.map_rpdo(1, 0x205, 255, {0x2000'04'08, 0x2000'05'08, 0x2000'06'08, 0x2000'09'08});
  node.operate();
  node.receive("205#01 02 03 04");
  const std::map<std::uint8_t, std::uint64_t> written = {{4, 1}, {5, 2}, {6, 3}, {9, 4}};
  for (std::uint8_t sub = 1; sub <= 16; ++sub) {
    const auto found = written.find(sub);
    EXPECT_EQ(node.number(0x2000, sub), found == written.end() ? 0xA0U + sub : found->second);
  }
}

TEST(PdoMapping, OfFewerValuesThanBeforeLeavesTheOthersAlone) {
  PdoNode node;
  const std::vector<std::uint32_t> four = {0x2010'04'10, 0x2010'01'10, 0x2010'03'10, 0x2010'02'10};
  node.map_rpdo(1, 0x205, 255, four);
  node.operate();
  node.receive("205#01 00 02 00 03 00 04 00");
  node.map_rpdo(1, 0x205, 255, {four[0], four[1]});
  // The second one may take a faster path than the first.
  for (int i = 0; i < 2; ++i) node.receive("205#0A 00 0B 00");
  EXPECT_EQ(node.number(0x2010, 4), 0x0AU);
  EXPECT_EQ(node.number(0x2010, 1), 0x0BU);
  EXPECT_EQ(node.number(0x2010, 3), 3U);
  EXPECT_EQ(node.number(0x2010, 2), 4U);
}

TEST(PdoMapping, OfWholeBytesInAnyOrderAndOfAnySizesLeavesAndArrivesAsItStands) {
  const std::vector<std::vector<std::uint32_t>> mappings = {
      {0x2010'01'10, 0x2010'02'10, 0x2010'03'10, 0x2010'04'10},
      {0x2010'04'10, 0x2010'03'10, 0x2010'02'10, 0x2010'01'10},
      {0x2010'01'10, 0x2010'03'10, 0x2000'01'08},
      {0x2000'01'08, 0x2000'03'08, 0x2000'05'08},
      {0x2000'02'08, 0x2000'01'08, 0x2020'01'20, 0x2010'01'10},
      {0x2020'02'20, 0x2020'01'20},
      {0x2020'01'20, 0x2020'02'20},
      {0x2020'03'20},
  };
  for (const std::vector<std::uint32_t>& mapped : mappings) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 255, mapped);
    node.map_tpdo(1, 0x185, 253, mapped);
    node.operate();
    unsigned bytes = 0;
    for (const std::uint32_t entry : mapped) bytes += (entry & 0xFF) / 8;
    std::array<std::uint8_t, 8> image = {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88};
    // The second one may take a faster path than the first.
    for (int i = 0; i < 2; ++i) {
      image[0] = static_cast<std::uint8_t>(image[0] + 0x80);
      node.node.receive(Frame::data_frame(0x205, std::span(image).first(bytes)), node.now);
      unsigned position = 0;
      for (const std::uint32_t entry : mapped) {
        std::uint64_t expected = 0;
        std::memcpy(&expected, &image[position], (entry & 0xFF) / 8);
        EXPECT_EQ(node.number(static_cast<std::uint16_t>(entry >> 16),
                              static_cast<std::uint8_t>(entry >> 8)),
                  expected);
        position += (entry & 0xFF) / 8;
      }
      node.sent.clear();
      node.node.receive(Frame::remote_frame(0x185, static_cast<std::uint8_t>(bytes)), node.now);
      ASSERT_EQ(node.sent.size(), 1U);
      EXPECT_EQ(node.sent[0].frame, Frame::data_frame(0x185, std::span(image).first(bytes)));
    }
  }
}

TEST(PdoMapping, SeesAHookThatComesWhileThePdoWorks) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2062'00'10});
  node.map_tpdo(1, 0x185, 253, {0x2062'00'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  Hook hook{.first = 0x2062, .last = 0x2062};
  int told = 0;
  auto tell = [&](const Entry&, Source) { ++told; };
  auto refresh = [&](const Entry& entry) {
    const std::array<std::uint8_t, 2> bytes = {0x0A, 0x0B};
    node.node.dictionary().set(entry, bytes);
    return none;
  };
  hook.after_write = Callback<void(const Entry&, Source)>::of(tell);
  hook.before_read = Callback<AbortCode(const Entry&)>::of(refresh);
  node.node.dictionary().attach(hook);
  node.receive("205#03 00");
  EXPECT_EQ(told, 1);
  EXPECT_EQ(node.number(0x2062, 0), 3U);
  node.receive("185#R");
  node.expect({"185#0A 0B"});
}

TEST(PdoMapping, SeesATpdoThatComesToWatchWhatAnRpdoWrites) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 00");
  node.receive("205#02 00");
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.expect({});
  node.receive("205#03 00");
  node.expect({"185#03 00"});
}

TEST(PdoMapping, WhichTheApplicationOverwritesPastAllHooksHoldsWhenThePdoIsSetAnew) {
  PdoNode node;
  Hook hook{.first = 0x2000, .last = 0x2000};
  node.node.dictionary().attach(hook);
  node.map_rpdo(1, 0x205, 255, {0x2060'00'08, 0x2000'01'08});
  node.operate();
  node.receive("205#0A 11");
  node.set(0x1600, 1, 0x2020'01'20);
  node.set(0x1600, 2, 0x2000'02'08);
  node.receive("205#0B 22");
  EXPECT_EQ(node.number(0x2060, 0), 0x0BU);
  EXPECT_EQ(node.number(0x2000, 1), 0x22U);
  EXPECT_EQ(node.number(0x2020, 1), 0U);
  ASSERT_EQ(node.write(0x1400, 1, 0x205), none);
  node.receive("205#01 02 03 04 33");
  EXPECT_EQ(node.number(0x2020, 1), 0x0403'0201U);
  EXPECT_EQ(node.number(0x2000, 2), 0x33U);
  EXPECT_EQ(node.number(0x2060, 0), 0x0BU);
}

/// Limits, hooks, watchers, strings, dummies, odd sizes: the record is read while a PDO is set, and
/// for none of its frames, whatever is attached to its values later.
TEST(PdoMapping, IsReadWhenItIsSetAndForNoFrame) {
  PdoNode node;
  Hook hook{.first = 0x2062, .last = 0x2062};
  node.node.dictionary().attach(hook);
  node.map_rpdo(1, 0x205, 255, {0x2060'00'08, 0x2061'00'10, 0x2062'00'10});
  node.map_rpdo(2, 0x305, 255, {0x2070'00'20, 0x0005'00'08, 0x2030'01'01, 0x2040'03'04});
  node.map_rpdo(3, 0x405, 1, {0x2010'01'10});
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10, 0x2061'00'10});
  node.map_tpdo(2, 0x285, 1, {0x2062'00'10, 0x2070'00'20});
  node.operate();
  const std::uint32_t reads = node.node.mapping_reads();
  if constexpr (!is_small_machine) EXPECT_GT(reads, 0U);
  const auto run = [&] {
    for (const char* frame : {"205#0A 01 00 02 00", "205#FE 01 00 02 00", "205#0B 02 00 03 00",
                              "305#61 62 63 64 00 03", "405#07 00", "080#", "305#00"}) {
      node.receive(frame);
    }
    node.sent.clear();
  };
  run();
  Hook late{.first = 0x2060, .last = 0x2070};
  node.node.dictionary().attach(late);
  run();
  node.node.dictionary().detach(late);
  run();
  EXPECT_EQ(node.node.mapping_reads(), reads);
}

TEST(PdoMapping, OfANeighbourOfAWatchedValueTellsNobody) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2010'02'10});
  node.map_tpdo(1, 0x185, 255, {0x2010'01'10});
  node.operate();
  for (int i = 1; i <= 3; ++i) {
    node.node.receive(
        Frame::data_frame(0x205, std::array<std::uint8_t, 2>{static_cast<std::uint8_t>(i), 0}),
        node.now);
    EXPECT_EQ(node.number(0x2010, 2), static_cast<std::uint64_t>(i));
    if (is_small_machine) continue;
    EXPECT_EQ(node.node.deadline(), Time::max()) << "nobody is to be told";
  }
  node.expect({});
  node.set(0x2010, 1, 9);
  node.expect({"185#09 00"});
}

/// A hook of each kind, some of them attached and detached while the PDO works.
TEST(PdoMapping, AsksAndTellsAllWhoAreAtTheTimeOfTheFrame) {
  struct Asked {
    explicit Asked(std::uint16_t first, std::uint16_t last) : hook{.first = first, .last = last} {
      hook.before_write = Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::of(ask);
      hook.after_write = Callback<void(const Entry&, Source)>::of(tell);
    }
    AbortCode answer = none;
    int asked = 0;
    int told = 0;
    std::function<AbortCode(const Entry&, std::span<const std::uint8_t>)> ask =
        [this](const Entry&, std::span<const std::uint8_t>) { return ++asked, answer; };
    std::function<void(const Entry&, Source)> tell = [this](const Entry&, Source) { ++told; };
    Hook hook;
  };
  PdoNode node;
  Asked one(0x2010, 0x2010);
  Asked both(0x2010, 0x2020);
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10, 0x2020'01'20});
  node.operate();
  const auto receive = [&] { node.receive("205#01 00 02 00 00 00"); };
  receive();
  node.node.dictionary().attach(one.hook);
  receive();
  EXPECT_EQ(one.asked, 1);
  EXPECT_EQ(one.told, 1);
  node.node.dictionary().attach(both.hook);
  receive();
  EXPECT_EQ(one.told, 2);
  EXPECT_EQ(both.told, 2) << "both values";
  both.answer = value_range;
  receive();
  EXPECT_EQ(both.told, 2);
  EXPECT_EQ(one.told, 2);
  EXPECT_EQ(node.errors(), (std::vector<std::string>{"+8200/1"}));
  node.node.dictionary().detach(both.hook);
  receive();
  EXPECT_EQ(one.told, 3);
  EXPECT_EQ(both.told, 2);
  EXPECT_EQ(node.errors(), (std::vector<std::string>{"-8200/1"}));
  node.node.dictionary().detach(one.hook);
  receive();
  EXPECT_EQ(one.told, 3);
}

}  // namespace
}  // namespace canvoy::pdo_mapping_test
