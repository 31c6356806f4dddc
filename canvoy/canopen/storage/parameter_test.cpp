#include "canvoy/canopen/storage/parameter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/storage/testing/storage_node.hpp"
#include "canvoy/canopen/testing/held_dictionary.hpp"

namespace canvoy::parameter_test {
namespace {

constexpr EntryShape writable{.type = DataType::unsigned16, .access = Access::rw};

TEST(Parameter, IsWhatSdoMayReadAndWrite) {
  EXPECT_TRUE(is_parameter(0x2000, writable));
  for (const Access access : {Access::none, Access::ro, Access::wo, Access::const_}) {
    EXPECT_FALSE(is_parameter(0x2000, {.access = access}));
  }
  EXPECT_TRUE(is_parameter(0x2000, {.access = Access::rw | Access::tpdo | Access::rpdo}));
}

TEST(Parameter, IsNoDomainAndNoValueOfTheProcess) {
  EXPECT_FALSE(is_parameter(0x2000, {.type = DataType::domain, .access = Access::rw}));
  EXPECT_FALSE(is_parameter(0x2000, {.type = DataType{0x20}, .access = Access::rw}));
  EXPECT_FALSE(is_parameter(0x2000, {.access = Access::rw, .traits = EntryTraits::not_stored}));
}

// CiA 301 and 302: objects that trigger an action when written, or that report a state.
TEST(Parameter, IsNoObjectThatStandsForAnActionOrAState) {
  for (const std::uint16_t index : std::to_array<std::uint16_t>(
           {0x1001, 0x1003, 0x1010, 0x1011, 0x1013, 0x1023, 0x1024, 0x1F00, 0x1F01, 0x1F10, 0x1F25,
            0x1F50, 0x1F51, 0x1F57, 0x1F82, 0x1F83})) {
    EXPECT_FALSE(is_parameter(index, writable)) << std::hex << index;
  }
  for (const std::uint16_t index : std::to_array<std::uint16_t>(
           {0x1005, 0x1006, 0x1007, 0x100C, 0x1012, 0x1014, 0x1016, 0x1017, 0x1019,
            0x1020, 0x1028, 0x1029, 0x1201, 0x1280, 0x1400, 0x1600, 0x1800, 0x1A00,
            0x1F26, 0x1F55, 0x1F80, 0x1F81, 0x1F89, 0x1FA0, 0x1FD0})) {
    EXPECT_TRUE(is_parameter(index, writable)) << std::hex << index;
  }
}

TEST(Parameter, BelongsToTheGroupsOfItsIndex) {
  struct Case {
    std::uint16_t index;
    std::vector<std::uint8_t> groups;
  };
  const Case cases[] = {{0x0FFF, {1}},    {0x1000, {1, 2}}, {0x1FFF, {1, 2}}, {0x2000, {1, 4}},
                        {0x20FF, {1, 4}}, {0x2100, {1, 5}}, {0x2200, {1}},    {0x5FFF, {1}},
                        {0x6000, {1, 3}}, {0x9FFF, {1, 3}}, {0xA000, {1}},    {0xFFFF, {1}}};
  for (const Case& expected : cases) {
    std::vector<std::uint8_t> found;
    for (unsigned sub = 0; sub < 256; ++sub) {
      const auto group = static_cast<std::uint8_t>(sub);
      if (is_in_group(expected.index, group, stored_groups)) found.push_back(group);
    }
    EXPECT_EQ(found, expected.groups) << std::hex << expected.index;
  }
}

TEST(Parameter, GroupFourIsAllOfAMakerWhoDoesNotDivide) {
  EXPECT_TRUE(is_in_group(0x2000, 4, manufacturer_group));
  EXPECT_TRUE(is_in_group(0x5FFF, 4, manufacturer_group));
  EXPECT_FALSE(is_in_group(0x6000, 4, manufacturer_group));
  EXPECT_FALSE(is_in_group(0x2000, 5, manufacturer_group));
}

TEST(Parameter, AWalkComesByAllOfThemInOrder) {
  const Held held(stored_layout.tables());
  std::vector<std::string> found;
  Entry entry;
  for (ParameterWalk walk(held.dictionary); walk.next(entry);) {
    char text[16];
    std::snprintf(text, sizeof text, "%04X:%u", entry.index, entry.sub);
    found.emplace_back(text);
  }
  EXPECT_EQ(found,
            (std::vector<std::string>{"1014:0", "1017:0", "2000:0", "2010:0", "2100:0", "6000:0",
                                      "6020:1", "6020:2", "6021:1", "6021:2", "A000:0"}));
}

TEST(Parameter, AWalkEndsInADictionaryOf254EntriesAndOfNone) {
  const Held held(shapes.tables());
  std::size_t count = 0;
  Entry entry;
  for (ParameterWalk walk(held.dictionary); walk.next(entry);) ++count;
  // 0001h; 1018h: 2; 6000h: 254; 16 objects with 4 + 1; FFFFh
  EXPECT_EQ(count, 1U + 2 + 254 + 16 * 5 + 1);
  const Held empty{DictionaryTables{}};
  EXPECT_FALSE(ParameterWalk(empty.dictionary).next(entry));
}

/// Signature of the dictionary that differs from stored_layout in one place.
template <class Change>
std::uint32_t signature_with(Change change) {
  auto objects = stored_objects;
  auto entries = stored_entries;
  change(objects, entries);
  const auto layout = lay_out(objects, entries);
  const Held held(layout.tables());
  return parameter_signature(held.dictionary);
}

TEST(Parameter, TheSignatureTellsOtherParametersApart) {
  const std::uint32_t own = signature_with([](auto&, auto&) {});
  EXPECT_NE(own, signature_with([](auto& objects, auto&) { objects[8].index = 0x2101; }));
  EXPECT_NE(own, signature_with([](auto& objects, auto&) { objects[11].count = 3; }));
  EXPECT_NE(own, signature_with([](auto&, auto& entries) { entries[10].capacity = 11; }));
  EXPECT_NE(own,
            signature_with([](auto&, auto& entries) { entries[11].type = DataType::integer16; }));
  EXPECT_NE(own, signature_with([](auto&, auto& entries) { entries[9].access = Access::ro; }));
}

TEST(Parameter, TheSignatureDoesNotCareForDefaultsAndRanges) {
  const std::uint32_t own = signature_with([](auto&, auto&) {});
  EXPECT_EQ(own, signature_with([](auto&, auto& entries) { entries[12].high = 500; }));
  EXPECT_EQ(own, signature_with([](auto&, auto& entries) { entries[12].initial = 5; }));
  EXPECT_EQ(own, signature_with([](auto&, auto& entries) { entries[16].initial = 5; }));
}

}  // namespace
}  // namespace canvoy::parameter_test
