// The expectations are typed from clause 12 of CiA 852, with its errata.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "canvoy/profiles/cia852.hpp"

namespace canvoy::pdos_test {
namespace {

const ObjectInfo& object_at(unsigned index) {
  const ObjectInfo* object = find_object(cia852::profile, index);
  EXPECT_NE(object, nullptr) << std::hex << index;
  return object != nullptr ? *object : cia852::device_type_object;
}

struct Mapping852 {
  const char* source;
  unsigned number;
  unsigned index;
  std::vector<std::uint32_t> mapped;
};

/// For each kind: the first set, which is printed, the second and the last.
const Mapping852 tpdos[] = {
    {"Table 12", 1, 0x1A00, {0x64010110, 0x64010210, 0x64010310, 0x60000108, 0x60000208}},
    {"12.2.2", 5, 0x1A04, {0x64010410, 0x64010510, 0x64010610, 0x60000308, 0x60000408}},
    {"12.2.2", 19, 0x1A12, {0x64012E10, 0x64012F10, 0x64013010, 0x60001F08, 0x60002008}},
    {"Table 16", 20, 0x1A13, {0x60002108, 0x64013110, 0x60002208, 0x64013210}},
    {"12.2.4", 21, 0x1A14, {0x60002308, 0x64013310, 0x60002408, 0x64013410}},
    {"12.2.4", 27, 0x1A1A, {0x60002F08, 0x64013F10, 0x60003008, 0x64014010}},
    {"Table 20", 28, 0x1A1B, {0x61208120, 0x61208220}},
    {"12.2.6", 29, 0x1A1C, {0x61208320, 0x61208420}},
    {"12.2.6", 31, 0x1A1E, {0x61208720, 0x61208820}},
    {"Table 24", 32, 0x1A1F, {0x64014110, 0x64014210, 0x64014310, 0x64014410}},
    {"12.2.8", 33, 0x1A20, {0x64014510, 0x64014610, 0x64014710, 0x64014810}},
    {"Table 28",
     34,
     0x1A21,
     {0x60003108, 0x60003208, 0x60003308, 0x60003408, 0x60003508, 0x60003608, 0x60003708,
      0x60003808}},
    {"12.2.10",
     35,
     0x1A22,
     {0x60003908, 0x60003A08, 0x60003B08, 0x60003C08, 0x60003D08, 0x60003E08, 0x60003F08,
      0x60004008}},
    {"12.2.10",
     41,
     0x1A28,
     {0x60006908, 0x60006A08, 0x60006B08, 0x60006C08, 0x60006D08, 0x60006E08, 0x60006F08,
      0x60007008}}};
const Mapping852 rpdos[] = {
    {"Table 32",
     1,
     0x1600,
     {0x62000108, 0x62000208, 0x62000308, 0x62000408, 0x62000508, 0x62000608, 0x62000708,
      0x62000808}},
    {"Table 36", 2, 0x1601, {0x64110110, 0x64110210, 0x64110310, 0x64110410}},
    {"12.2.14", 4, 0x1603, {0x64110510, 0x64110610, 0x64110710, 0x64110810}},
    {"12.2.12",
     5,
     0x1604,
     {0x62000908, 0x62000A08, 0x62000B08, 0x62000C08, 0x62000D08, 0x62000E08, 0x62000F08,
      0x62001008}},
    {"12.2.12",
     11,
     0x160A,
     {0x62003908, 0x62003A08, 0x62003B08, 0x62003C08, 0x62003D08, 0x62003E08, 0x62003F08,
      0x62004008}},
    {"12.2.14", 12, 0x160B, {0x64110910, 0x64110A10, 0x64110B10, 0x64110C10}},
    {"12.2.14", 13, 0x160C, {0x64110D10, 0x64110E10, 0x64110F10, 0x64111010}},
    {"errata 25", 33, 0x1620, {0x64115D10, 0x64115E10, 0x64115F10, 0x64116010}}};

void expect_mapping(const Mapping852& expected, const char* name) {
  SCOPED_TRACE(testing::Message() << expected.source << ": " << name << " " << expected.number);
  const ObjectInfo& object = object_at(expected.index);
  EXPECT_EQ(object.name, name);
  EXPECT_EQ(object.first_number, expected.number);
  EXPECT_EQ(object.code, ObjectCode::record);
  EXPECT_EQ(object.category, Category::conditional);
  ASSERT_EQ(object.subs.size(), expected.mapped.size() + 1);
  EXPECT_EQ(object.subs[0].name, "Number of mapped application objects in PDO");
  EXPECT_EQ(object.subs[0].access, Access::rw);
  EXPECT_EQ(object.subs[0].initial.number, static_cast<std::int64_t>(expected.mapped.size()));
  for (unsigned sub = 1; sub <= expected.mapped.size(); ++sub) {
    const EntryInfo& entry = object.subs[sub];
    EXPECT_EQ(entry.sub_first, sub);
    EXPECT_EQ(entry.type, DataType::unsigned32);
    EXPECT_EQ(entry.access, Access::rw);
    EXPECT_TRUE(entry.or_const) << "rw or const";
    EXPECT_EQ(entry.initial.number, expected.mapped[sub - 1]) << std::hex << entry.initial.number;
  }
}

TEST(Cia852Pdos, TpdosMapWhatClause12Says) {
  for (const Mapping852& tpdo : tpdos) expect_mapping(tpdo, "TPDO # mapping parameter");
}
TEST(Cia852Pdos, RpdosMapWhatClause12Says) {
  for (const Mapping852& rpdo : rpdos) expect_mapping(rpdo, "RPDO # mapping parameter");
}

/// Number of times that the objects from `first` to `last` map each entry.
std::map<std::int64_t, unsigned> mapped_by(unsigned first, unsigned last) {
  std::map<std::int64_t, unsigned> count;
  for (const ObjectInfo* object : cia852::profile.objects) {
    if (object->index < first || object->index > last) continue;
    for (const EntryInfo& entry : object->subs) {
      if (entry.sub_first > 0) ++count[entry.initial.number];
    }
  }
  return count;
}

TEST(Cia852Pdos, EachInputAndOutputIsInOnePdo) {
  auto mapped = mapped_by(0x1A00, 0x1BFF);
  mapped.merge(mapped_by(0x1600, 0x17FF));
  std::size_t entries = 0;
  for (const std::uint16_t index :
       std::to_array<std::uint16_t>({0x6000, 0x6120, 0x6200, 0x6401, 0x6411})) {
    for (const EntryInfo& entry : object_at(index).subs) {
      if (entry.sub_first == 0) continue;
      ++entries;
      const auto value =
          index << 16 | entry.sub_first << 8 | static_cast<int>(bit_length(entry.type));
      EXPECT_EQ(mapped[value], 1U) << std::hex << value;
    }
  }
  EXPECT_EQ(mapped.size(), entries);
}

TEST(Cia852Pdos, TheUnusedPdosAreNotThere) {  // errata 26, 27; 12.2.15, 12.2.16
  std::set<unsigned> tpdo_numbers, rpdo_numbers;
  for (const ObjectInfo* object : cia852::profile.objects) {
    const unsigned number = (object->index & 0x1FFU) + 1;
    if (object->index >> 9 == 0x1800 >> 9 || object->index >> 9 == 0x1A00 >> 9) {
      EXPECT_EQ(object->first_number, number);
      tpdo_numbers.insert(number);
    } else if (object->index >> 9 == 0x1400 >> 9 || object->index >> 9 == 0x1600 >> 9) {
      EXPECT_EQ(object->first_number, number);
      rpdo_numbers.insert(number);
    }
  }
  std::set<unsigned> tpdos_used = {1}, rpdos_used = {1, 2};
  for (unsigned n = 5; n <= 41; ++n) tpdos_used.insert(n);
  for (unsigned n = 4; n <= 33; ++n) rpdos_used.insert(n);
  EXPECT_EQ(tpdo_numbers, tpdos_used);
  EXPECT_EQ(rpdo_numbers, rpdos_used);
  EXPECT_EQ(find_object(cia852::profile, 0x1829), nullptr);
  EXPECT_EQ(find_object(cia852::profile, 0x1421), nullptr);
}

struct Parameter {
  unsigned sub;
  const char* name;
  DataType type;
  bool rw_or_const;
  Category category;
  std::int64_t initial;
};
constexpr Parameter tpdo_parameters[] = {
    {2, "Transmission type", DataType::unsigned8, true, Category::mandatory, 0xFF},
    {3, "Inhibit time", DataType::unsigned16, false, Category::optional, 0},
    {5, "Event-timer", DataType::unsigned16, false, Category::optional, 0},
    {6, "SYNC start value", DataType::unsigned8, true, Category::optional, 0}};
constexpr Parameter rpdo_parameters[] = {
    {2, "Transmission type", DataType::unsigned8, true, Category::mandatory, 0xFF},
    {5, "Event-timer", DataType::unsigned16, false, Category::optional, 0}};

void expect_parameters(const ObjectInfo& object, std::span<const Parameter> expected) {
  SCOPED_TRACE(testing::Message() << object.name << " " << object.first_number);
  ASSERT_EQ(object.subs.size(), expected.size() + 2);
  EXPECT_EQ(object.code, ObjectCode::record);
  EXPECT_EQ(object.category, Category::conditional);
  EXPECT_EQ(object.subs[0].name, "Highest sub-index supported");
  EXPECT_EQ(object.subs[0].access, Access::const_);
  EXPECT_EQ(object.subs[0].value.limits.low, 2);
  EXPECT_EQ(object.subs[1].name, "COB-ID");
  EXPECT_EQ(object.subs[1].type, DataType::unsigned32);
  EXPECT_TRUE(object.subs[1].or_const);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const EntryInfo& entry = object.subs[i + 2];
    EXPECT_EQ(entry.sub_first, expected[i].sub);
    EXPECT_EQ(entry.name, expected[i].name);
    EXPECT_EQ(entry.type, expected[i].type);
    EXPECT_EQ(entry.access, Access::rw);
    EXPECT_EQ(entry.or_const, expected[i].rw_or_const);
    EXPECT_EQ(entry.category, expected[i].category);
    EXPECT_EQ(entry.initial.number, expected[i].initial);
    EXPECT_EQ(entry.mapping, Mapping::no);
  }
}

TEST(Cia852Pdos, CommunicationParametersAreThoseOfTables10And30) {
  for (unsigned number = 1; number <= 41; number += number == 1 ? 4 : 1) {
    const ObjectInfo& object = object_at(0x17FF + number);
    EXPECT_EQ(object.name, "TPDO # communication parameter");
    expect_parameters(object, tpdo_parameters);
    EXPECT_EQ(object.subs[0].value.limits.high, 6);
  }
  for (unsigned number = 1; number <= 33; number += number == 2 ? 2 : 1) {
    const ObjectInfo& object = object_at(0x13FF + number);
    EXPECT_EQ(object.name, "RPDO # communication parameter");
    expect_parameters(object, rpdo_parameters);
    EXPECT_EQ(object.subs[0].value.limits.high, 5);  // errata 30
  }
}

TEST(Cia852Pdos, AllAreInvalidByDefault) {  // 12.1
  const EntryInfo& first = object_at(0x1800).subs[1];
  EXPECT_EQ(first.initial.kind, Default::Kind::plus_node_id);
  EXPECT_EQ(first.initial.number, 0x8000'0180);
  for (const ObjectInfo* object : cia852::profile.objects) {
    const bool is_parameter =
        object->index >> 9 == 0x1800 >> 9 || object->index >> 9 == 0x1400 >> 9;
    if (!is_parameter || object->index == 0x1800) continue;
    EXPECT_EQ(object->subs[1].initial.kind, Default::Kind::number);
    EXPECT_EQ(object->subs[1].initial.number, 0x8000'0000) << std::hex << object->index;
  }
}

TEST(Cia852Pdos, WhatBelongsToAnElementThatMayBeMissingMayBeMissing) {
  using enum Category;
  struct {
    unsigned index;
    std::vector<Category> categories;
  } const mappings[] = {
      {0x1A00, {mandatory, mandatory, conditional, mandatory, mandatory}},
      {0x1A13, {mandatory, mandatory, conditional, conditional}},  // errata 22
      {0x1A1B, {mandatory, Category::optional}},
      {0x1A1F, {mandatory, Category::optional, Category::optional, Category::optional}},
      {0x1601, {mandatory, Category::optional, Category::optional, Category::optional}}};
  for (const auto& [index, categories] : mappings) {
    for (unsigned sub = 1; sub <= categories.size(); ++sub) {
      EXPECT_EQ(object_at(index).subs[sub].category, categories[sub - 1])
          << std::hex << index << " " << sub;
    }
  }
  for (unsigned sub = 2; sub <= 8; ++sub) {
    EXPECT_EQ(object_at(0x1A21).subs[sub].category, Category::optional);
    EXPECT_EQ(object_at(0x1600).subs[sub].category, Category::optional);
  }
}

}  // namespace
}  // namespace canvoy::pdos_test
