#include "canvoy/canopen/dictionary/dictionary.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <vector>

#include "canvoy/canopen/device/heap_tables.hpp"
#include "canvoy/canopen/dictionary/initial_values.hpp"
#include "canvoy/canopen/testing/held_dictionary.hpp"

namespace canvoy::dictionary_test {
namespace {

bool exists(unsigned index, unsigned sub) {
  if (index == 0x0001 || index == 0xFFFF) return sub == 0;
  if (index == 0x1018) return sub == 0 || sub == 1 || sub == 3;
  if (index == 0x6000) return sub <= 254;
  if (index >= 0x6100 && index <= 0x610F) return sub <= 4 || sub == 9;
  return false;
}

TEST(DictionarySearch, FindsEachEntryThatExistsAndNoOther) {
  Held sut(shapes.tables());
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    const bool object_exists = exists(index, 0);
    const unsigned last_sub = object_exists ? 255 : 1;
    for (unsigned sub = 0; sub <= last_sub; ++sub) {
      const auto entry =
          sut.dictionary.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
      const AbortCode expected = exists(index, sub) ? AbortCode::none
                                 : object_exists    ? AbortCode::no_sub_index
                                                    : AbortCode::no_object;
      ASSERT_EQ(entry.abort(), expected) << std::hex << index << " " << sub;
      if (!entry) continue;
      ASSERT_EQ(entry->index, index);
      ASSERT_EQ(entry->sub, sub);
    }
  }
}

TEST(DictionarySearch, FindsNothingInAnEmptyDictionary) {
  Held sut(DictionaryTables{});
  EXPECT_EQ(sut.dictionary.find(0x1000, 0).abort(), AbortCode::no_object);
  EXPECT_EQ(sut.write(0x1000, 0, {0}), AbortCode::no_object);
  EXPECT_FALSE(sut.dictionary.set_number(0x1000, 0, 1));
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0U);
}

/// Objects with these indices, of so many in a row.
HeapTables tables_of(const std::map<unsigned, unsigned>& counts) {
  HeapTables tables;
  for (const auto& [index, count] : counts) {
    add_object(
        tables,
        {.index = static_cast<std::uint16_t>(index), .count = static_cast<std::uint16_t>(count)},
        std::to_array<EntryRow>({{.type = DataType::unsigned8}}));
  }
  return tables;
}

/// How they lie has no part in what is found: evenly, in one crowd, in two, alone, from end to end.
TEST(DictionarySearch, FindsObjectsHoweverTheirIndicesLie) {
  std::map<unsigned, unsigned> even, crowd, two, whole = {{0, 0x8000}, {0x8000, 0x8000}};
  for (unsigned i = 0; i < 300; ++i) {
    even[0x100 + 200 * i] = i % 3 == 0 ? 150 : 1;
    crowd[0x2000 + i] = 1;
    two[i < 290 ? 0x2000 + i : 0xFF00 + 10 * i - 2900] = 1;
  }
  for (const auto& counts : {even, crowd, two, whole, {{0x1000, 1}}, {{0x1000, 7}, {0xFFFF, 1}}}) {
    const HeapTables tables = tables_of(counts);
    Held sut(tables.tables());
    for (unsigned index = 0; index <= 0xFFFF; ++index) {
      const auto after = counts.upper_bound(index);
      const bool is_there =
          after != counts.begin() && index - std::prev(after)->first < std::prev(after)->second;
      const auto found = sut.dictionary.find(static_cast<std::uint16_t>(index), 0);
      ASSERT_EQ(static_cast<bool>(found), is_there) << std::hex << index;
      ASSERT_EQ(found->index, index);
    }
  }
}

TEST(DictionarySearch, GivesEachEntryItsOwnMemoryWithinTheBlock) {
  Held sut(shapes.tables());
  std::map<const std::uint8_t*, unsigned> owner;
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    for (unsigned sub = 0; sub <= 255; ++sub) {
      if (!exists(index, sub)) {
        if (!exists(index, 0)) break;
        continue;
      }
      const Entry entry =
          sut.entry(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
      for (const std::uint8_t& byte : entry.bytes()) {
        ASSERT_GE(&byte, sut.values.data());
        ASSERT_LT(&byte, sut.values.data() + sut.values.size());
        ASSERT_TRUE(owner.emplace(&byte, index << 8 | sub).second);
      }
    }
  }
  EXPECT_EQ(owner.size(), sut.values.size()) << "and leaves none unused";
}

TEST(DictionarySearch, FindsWhatANaiveSearchFindsInAnyLayout) {
  const bool held = rc::check("like a list", [] {
    HeapTables tables;
    std::map<unsigned, std::vector<bool>> model;  // object -> the sub-indices that exist
    unsigned index = 0x1000;
    const int count = *rc::gen::inRange(0, 12);
    for (int i = 0; i < count; ++i) {
      index += *rc::gen::inRange(0U, 3U);
      const auto objects = *rc::gen::inRange<std::uint16_t>(1, 4);
      std::vector<EntryRow> entries(*rc::gen::inRange(0U, 4U));
      std::vector<bool> subs(256);
      unsigned sub = *rc::gen::inRange(0U, 2U);
      for (EntryRow& entry : entries) {
        const unsigned length = *rc::gen::inRange(1U, 5U);
        entry.sub_first = static_cast<std::uint8_t>(sub);
        entry.sub_last = static_cast<std::uint8_t>(sub + length - 1);
        for (unsigned s = sub; s < sub + length; ++s) subs[s] = true;
        sub += length + *rc::gen::inRange(0U, 2U);
      }
      add_object(tables, {.index = static_cast<std::uint16_t>(index), .count = objects}, entries);
      for (unsigned o = 0; o < objects; ++o) model[index + o] = subs;
      index += objects;
    }
    Held sut(tables.tables());
    for (unsigned probe = 0x0FFF; probe < index + 3; ++probe) {
      for (unsigned sub = 0; sub < 30; ++sub) {
        const auto found =
            sut.dictionary.find(static_cast<std::uint16_t>(probe), static_cast<std::uint8_t>(sub));
        const AbortCode expected = !model.contains(probe) ? AbortCode::no_object
                                   : !model[probe][sub]   ? AbortCode::no_sub_index
                                                          : AbortCode::none;
        RC_ASSERT(found.abort() == expected);
      }
    }
  });
  EXPECT_TRUE(held);
}

// Access

constexpr auto accesses =
    lay_out(std::to_array<ObjectRow>({{.index = 0x2000, .entry_count = 5}}),
            std::to_array<EntryRow>(
                {{.access = Access::ro, .initial = 1},
                 {.sub_first = 1, .sub_last = 1, .access = Access::wo, .initial = 2},
                 {.sub_first = 2, .sub_last = 2, .access = Access::rw, .initial = 3},
                 {.sub_first = 3, .sub_last = 3, .access = Access::const_, .initial = 4},
                 {.sub_first = 4, .sub_last = 4, .access = Access::none}}));

TEST(DictionaryAccess, IsWhatTheEntryAllows) {
  Held sut(accesses.tables());
  EXPECT_EQ(sut.read(0x2000, 0), Bytes{1});
  EXPECT_EQ(sut.read(0x2000, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::write_only);
  EXPECT_EQ(sut.read(0x2000, 2), Bytes{3});
  EXPECT_EQ(sut.read(0x2000, 3), Bytes{4});
  sut.read(0x2000, 4);
  EXPECT_EQ(sut.abort, AbortCode::write_only);

  EXPECT_EQ(sut.write(0x2000, 0, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 1, {9}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2000, 2, {9}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2000, 3, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 4, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.dictionary.number(0x2000, 0), 1U);
  EXPECT_EQ(sut.dictionary.number(0x2000, 1), 9U);
}

TEST(DictionaryAccess, IsAskedBeforeLengthAndRange) {
  Held sut(accesses.tables());
  EXPECT_EQ(sut.write(0x2000, 0, {1, 2, 3}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 0, {}), AbortCode::read_only);
}

TEST(DictionaryAccess, DoesNotBindTheDeviceItself) {
  Held sut(accesses.tables());
  EXPECT_TRUE(sut.dictionary.set_number(0x2000, 0, 7));
  EXPECT_EQ(sut.read(0x2000, 0), Bytes{7});
}

TEST(DictionaryAccess, CombinesItsBits) {
  EXPECT_TRUE(allows(Access::rw, Access::sdo_read));
  EXPECT_TRUE(allows(Access::rw | Access::tpdo, Access::tpdo));
  EXPECT_FALSE(allows(Access::ro | Access::tpdo, Access::rpdo));
  EXPECT_FALSE(allows(Access::const_, Access::sdo_write));
  EXPECT_FALSE(allows(Access::ro, Access::rw));
}

// Defaults

constexpr auto defaults = lay_out(
    std::to_array<ObjectRow>({{.index = 0x0FFF, .entry_count = 1},
                              {.index = 0x1000, .entry_count = 1},
                              {.index = 0x1FFE, .count = 4, .entry_count = 2},
                              {.index = 0x2010, .entry_count = 1},
                              {.index = 0x2011, .entry_count = 1},
                              {.index = 0x2012, .entry_count = 1},
                              {.index = 0x2013, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.access = Access::rw, .initial = 1},
         {.type = DataType::unsigned32,
          .access = Access::rw,
          .traits = EntryTraits::plus_node_id,
          .initial = 0x8000'0180},
         {.access = Access::rw, .initial = 3},
         {.sub_first = 1, .sub_last = 2, .type = DataType::integer40, .initial = -4},
         {.type = DataType::real32, .access = Access::rw, .initial = 0x3F80'0000},
         {.type = DataType::visible_string,
          .access = Access::rw,
          .capacity = 4,
          .initial_text = "ab"},
         {.type = DataType::unsigned64, .access = Access::rw, .initial = 0x0102'0304'0506'0708},
         {.access = Access::rw, .traits = EntryTraits::plus_node_id, .initial = 0x10}}));

/// They are restored row by row, on a host also from a block of all of them.
class DictionaryDefault : public testing::TestWithParam<bool> {
 protected:
  static DictionaryTables tables() {
    if constexpr (is_small_machine) return defaults.tables();
    return GetParam() ? tables_with_initial_values<defaults>() : defaults.tables();
  }
};
INSTANTIATE_TEST_SUITE_P(FromABlock, DictionaryDefault, testing::Bool());

TEST_P(DictionaryDefault, IsThatOfTheTypeInTheOrderOfTheWire) {
  Held sut(tables(), 0x0A);
  EXPECT_EQ(sut.read(0x0FFF, 0), (Bytes{1}));
  EXPECT_EQ(sut.read(0x1000, 0), (Bytes{0x8A, 0x01, 0x00, 0x80}));
  EXPECT_EQ(sut.read(0x1FFF, 2), (Bytes{0xFC, 0xFF, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(sut.read(0x2011, 0), (Bytes{'a', 'b'}));
  EXPECT_EQ(sut.read(0x2012, 0), (Bytes{8, 7, 6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(sut.read(0x2013, 0), (Bytes{0x1A}));
}

TEST_P(DictionaryDefault, IsRestoredForTheObjectsThatAreAskedFor) {
  Held sut(tables(), 0x0A);
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0x8000'018AU);
  EXPECT_EQ(sut.dictionary.number(0x2001, 2), 0xFF'FFFF'FFFCU);
  EXPECT_EQ(sut.read(0x2010, 0), (Bytes{0x00, 0x00, 0x80, 0x3F}));

  const std::uint16_t all[] = {0x0FFF, 0x1000, 0x1FFE, 0x1FFF, 0x2000, 0x2001, 0x2010};
  for (const std::uint16_t index : all) sut.dictionary.set_number(index, 0, 0x77);
  sut.dictionary.restore_defaults(0x1000, 0x1FFF, 0x0B);
  EXPECT_EQ(sut.dictionary.number(0x0FFF, 0), 0x77U);
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0x8000'018BU);
  EXPECT_EQ(sut.dictionary.number(0x1FFE, 0), 3U);
  EXPECT_EQ(sut.dictionary.number(0x1FFF, 0), 3U);
  EXPECT_EQ(sut.dictionary.number(0x2000, 0), 0x77U) << "of the same row, but not asked for";
  EXPECT_EQ(sut.dictionary.number(0x2001, 0), 0x77U);
  EXPECT_EQ(sut.dictionary.number(0x2010, 0), 0x77U);
}

// Watchers

TEST(DictionaryChanges, TellTheWatchersOfWhatChangedAndOfNothingElse) {
  Held sut(shapes.tables());
  sut.dictionary.watch(sut.entry(0x1018, 1), 0x0000'0004);
  sut.dictionary.watch(sut.entry(0x6000, 7), 0x8000'0000);
  sut.dictionary.watch(sut.entry(0x6000, 7), 0x0000'0001);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x0001, 0, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x0000'0004U);
  sut.dictionary.set_number(0x6000, 8, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x8000'0005U) << "a row has its watchers in common";
  sut.dictionary.clear_changes();
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0U) << "the same value again";
  sut.write(0x1018, 1, {1, 0, 0, 0});
  EXPECT_EQ(sut.dictionary.changes(), 0x0000'0004U) << "from the bus";
  EXPECT_EQ(sut.write(0x1018, 1, {1}), AbortCode::length_too_low);
  sut.dictionary.clear_changes();
  sut.dictionary.mark_changed(0x40);
  EXPECT_EQ(sut.dictionary.changes(), 0x40U);
}

TEST(DictionaryChanges, AreNotToldAnyMoreToWhoHasGone) {
  Held sut(shapes.tables());
  const std::uint32_t before = sut.dictionary.revision();
  sut.dictionary.watch(sut.entry(0x1018, 1), 0x3);
  const std::uint32_t watched = sut.dictionary.revision();
  EXPECT_NE(watched, before);
  sut.dictionary.unwatch(0x1);
  EXPECT_NE(sut.dictionary.revision(), watched);
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x2U);
}

TEST_P(DictionaryDefault, IsAChangeWhereItReturns) {
  Held sut(tables());
  sut.dictionary.watch(sut.entry(0x0FFF), 1);
  sut.dictionary.watch(sut.entry(0x1000), 2);
  sut.dictionary.restore_defaults(0, 0xFFFF, 5);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x0FFF, 0, 2);
  sut.dictionary.clear_changes();
  sut.dictionary.restore_defaults(0, 0xFFFF, 5);
  EXPECT_EQ(sut.dictionary.changes(), 1U);
  EXPECT_EQ(sut.dictionary.number(0x0FFF, 0), 1U);
  sut.dictionary.clear_changes();
  sut.dictionary.restore_defaults(0, 0xFFFF, 6);
  EXPECT_EQ(sut.dictionary.changes(), 2U) << "a default that follows the node-ID";
  sut.dictionary.set_number(0x1000, 0, 0x8000'0180);
  sut.dictionary.clear_changes();
  sut.dictionary.restore_defaults(0, 0xFFFF, 6);
  EXPECT_EQ(sut.dictionary.changes(), 2U) << "it was as the description has it";
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0x8000'0186U);
}

}  // namespace
}  // namespace canvoy::dictionary_test
