// Folded tables have the contents of the layout that they are made of.
#include "canvoy/canopen/dictionary/folded_tables.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"
#include "canvoy/canopen/testing/held_dictionary.hpp"
#include "canvoy/canopen/testing/static_pdo_node.hpp"

namespace canvoy::folded_tables_test {
namespace {

/// Contents of tables for one entry.
struct Said {
  EntryShape shape;
  std::ptrdiff_t place = 0;  ///< of the value in the block
  std::vector<std::int64_t> limits;
  std::uint64_t initial = 0;

  friend bool operator==(const Said&, const Said&) = default;
};

Said said_of(Held& held, const Entry& entry) {
  Said said{.shape = *entry.row, .place = entry.value - held.values.data(), .limits = {}};
  if (has(entry.row->traits, EntryTraits::limited)) {
    const auto all = held.tables.numbers.subspan(entry.row->limits);
    const bool has_sentinel = has(entry.row->traits, EntryTraits::has_sentinel);
    said.limits.assign(all.begin(), all.begin() + (has_sentinel ? 3 : 2));
  }
  said.shape.limits = 0;
  if (!entry.row->is_text()) said.initial = held.dictionary.default_number(entry);
  return said;
}

/// Checks that each index and sub-index is found in both or in neither, with equal contents.
void expect_alike(const DictionaryTables& layout, const DictionaryTables& folded) {
  Held one(layout);
  Held other(folded);
  ASSERT_EQ(one.values, other.values) << "defaults";
  unsigned found = 0;
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    for (unsigned sub = 0; sub <= 17; ++sub) {
      const auto number = static_cast<std::uint16_t>(index);
      const auto expected = one.dictionary.find(number, static_cast<std::uint8_t>(sub));
      const auto entry = other.dictionary.find(number, static_cast<std::uint8_t>(sub));
      ASSERT_EQ(expected.abort(), entry.abort()) << std::hex << index << ":" << sub;
      if (!entry) continue;
      ASSERT_EQ(said_of(one, *expected), said_of(other, *entry)) << std::hex << index << ":" << sub;
      ++found;
    }
  }
  EXPECT_GT(found, 10U);
}

TEST(FoldedTables, SayWhatTheirLayoutSays) {
  static constexpr auto stored = fold_tables<stored_layout>();
  expect_alike(stored_layout.tables(), stored.tables());
  static constexpr auto shaped = fold_tables<shapes>();
  expect_alike(shapes.tables(), shaped.tables());
  static constexpr auto constant = fold_tables<static_pdo_layout>();
  expect_alike(static_pdo_layout.tables(), constant.tables());
}

constexpr auto records = [] {
  constexpr EntryRow count{.access = Access::const_, .initial = 2};
  constexpr auto number = [](std::uint8_t sub, std::int64_t initial) {
    return EntryRow{.sub_first = sub,
                    .sub_last = sub,
                    .type = DataType::unsigned32,
                    .access = Access::rw,
                    .initial = initial};
  };
  constexpr EntryRow wide{.type = DataType::unsigned64,
                          .access = Access::rw,
                          .traits = EntryTraits::limited,
                          .low = 1,
                          .high = 9,
                          .initial = 5};
  return lay_out(
      std::to_array<ObjectRow>({{.index = 0x1006, .entry_count = 1},
                                {.index = 0x1007, .entry_count = 1},
                                {.index = 0x1400, .entry_count = 3},
                                {.index = 0x1401, .entry_count = 3},
                                {.index = 0x1402, .entry_count = 3},
                                {.index = 0x15FF, .entry_count = 3},
                                {.index = 0x1600, .entry_count = 3},
                                {.index = 0x1601, .entry_count = 3},
                                {.index = 0x1603, .entry_count = 3},
                                {.index = 0x2000, .entry_count = 1},
                                {.index = 0x2002, .entry_count = 1}}),
      std::to_array<EntryRow>({number(0, 7), number(0, 7),                       //
                               count,        number(1, 0x201), number(2, 0x10),  //
                               count,        number(1, 0x301), number(2, 0x11),  //
                               count,        number(1, 0x401), number(2, 0x12),  //
                               count,        number(1, 0),     number(2, 0),     //
                               count,        number(1, 0),     number(2, 0),     //
                               count,        number(1, 0),     number(2, 0),     //
                               count,        number(1, 0),     number(2, 0),    wide, wide}));
}();
constexpr auto folded_records = fold_tables<records>();

TEST(FoldedTables, MakeOneRowOfPdoRecordsThatFollowEachOther) {
  using Row = std::array<unsigned, 3>;  // index, count, defaults from one to the next
  std::vector<Row> rows;
  for (const ObjectRow& object : folded_records.objects) {
    rows.push_back({object.index, object.count, object.default_pitch});
  }
  // 1006h and 1007h are no PDO records; 15FFh and 1600h are of two kinds.
  const std::vector<Row> expected{{0x1006, 1, 0}, {0x1007, 1, 0}, {0x1400, 3, 3}, {0x15FF, 1, 0},
                                  {0x1600, 2, 0}, {0x1603, 1, 0}, {0x2000, 1, 0}, {0x2002, 1, 0}};
  EXPECT_EQ(rows, expected);
  expect_alike(records.tables(), folded_records.tables());
}

TEST(FoldedTables, HaveEachThingOnce) {
  EXPECT_EQ(folded_records.entries.size(), 5U) << "a variable, a record of three, a wide variable";
  EXPECT_EQ(folded_records.defaults.size(), 1U + 9 + 3) << "7, three records, and one of zeros";
  EXPECT_EQ(folded_records.numbers.size(), 3U) << "the limits and the default of 2000h and 2002h";
}

}  // namespace
}  // namespace canvoy::folded_tables_test
