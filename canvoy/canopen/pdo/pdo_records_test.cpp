// The constant records of PDOs that the compiler accepts, so that nothing checks them at run time
// (CiA 301, 7.3.5, 7.5.2.35 to 7.5.2.38).
#include "canvoy/canopen/pdo/pdo_records.hpp"

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <vector>

namespace canvoy::pdo_records_test {
namespace {

constexpr Access mappable = Access::rw | Access::rpdo | Access::tpdo;

constexpr EntryRow constant(std::uint8_t sub, DataType type, std::int64_t initial) {
  return {.sub_first = sub,
          .sub_last = sub,
          .type = type,
          .access = Access::const_,
          .initial = initial};
}
constexpr EntryRow plus_node_id(EntryRow row) {
  row.traits = row.traits | EntryTraits::plus_node_id;
  return row;
}

/// One PDO of each direction, both with four values; a fifth is not counted.
constexpr auto objects = std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 2},
                                                   {.index = 0x1600, .entry_count = 6},
                                                   {.index = 0x1800, .entry_count = 2},
                                                   {.index = 0x1A00, .entry_count = 6},
                                                   {.index = 0x2000, .entry_count = 2},
                                                   {.index = 0x2001, .entry_count = 1}});
constexpr auto described_rows = std::to_array<EntryRow>({
    plus_node_id(constant(1, DataType::unsigned32, 0x200)),
    constant(2, DataType::unsigned8, 255),
    constant(0, DataType::unsigned8, 4),
    constant(1, DataType::unsigned32, 0x2000'01'10),
    constant(2, DataType::unsigned32, 0x2000'02'10),
    constant(3, DataType::unsigned32, 0x2000'03'10),
    constant(4, DataType::unsigned32, 0x0006'00'10),
    constant(5, DataType::unsigned32, 0x2000'05'10),
    plus_node_id(constant(1, DataType::unsigned32, 0x180)),
    constant(2, DataType::unsigned8, 255),
    constant(0, DataType::unsigned8, 4),
    constant(1, DataType::unsigned32, 0x2000'01'10),
    constant(2, DataType::unsigned32, 0x2000'02'10),
    constant(3, DataType::unsigned32, 0x2000'03'10),
    constant(4, DataType::unsigned32, 0x2000'04'10),
    constant(5, DataType::unsigned32, 0x2000'05'10),
    {.access = Access::const_, .initial = 5},
    {.sub_first = 1, .sub_last = 5, .type = DataType::unsigned16, .access = mappable},
    {.type = DataType::unsigned16, .access = Access::rw},
});
constexpr auto layout = lay_out(objects, described_rows);
using Rows = std::remove_const_t<decltype(described_rows)>;

/// A change of one entry, and whether its PDO is valid with it.
struct Change {
  unsigned index = 0;
  unsigned sub = 0;
  std::int64_t initial = 0;
  bool is_right = false;
};
void PrintTo(const Change& change, std::ostream* out) {
  *out << std::hex << change.index << "h:" << change.sub << " = " << change.initial << "h";
}

Rows rows_with(const Change& change) {
  Rows rows = described_rows;
  for (const ObjectRow& object : layout.objects) {
    if (object.index != change.index) continue;
    for (unsigned i = 0; i < object.entry_count; ++i) {
      EntryRow& row = rows.at(object.entry_first + i);
      if (row.sub_first == change.sub) row.initial = change.initial;
    }
  }
  return rows;
}

PdoRecords records_of(const Rows& rows, unsigned index) {
  const auto changed = lay_out(objects, rows);
  const bool receives = index < 0x1800;
  return pdo_records(changed.tables(), receives ? PdoDirection::receive : PdoDirection::transmit);
}

TEST(PdoRecords, AreConstantWhereNoClientCanWriteThemAndAllIsRight) {
  EXPECT_EQ(pdo_records(layout.tables(), PdoDirection::receive), PdoRecords::constant);
  EXPECT_EQ(pdo_records(layout.tables(), PdoDirection::transmit), PdoRecords::constant);
}

class ChangedPdoRecord : public testing::TestWithParam<Change> {};

TEST_P(ChangedPdoRecord, IsLeftToTheChecksAtRunTimeWhereItIsWrong) {
  const PdoRecords expected = GetParam().is_right ? PdoRecords::constant : PdoRecords::writable;
  EXPECT_EQ(records_of(rows_with(GetParam()), GetParam().index), expected);
}

TEST_P(ChangedPdoRecord, SaysNothingOfTheOtherDirection) {
  const unsigned other = GetParam().index < 0x1800 ? 0x1800 : 0x1400;
  EXPECT_EQ(records_of(rows_with(GetParam()), other), PdoRecords::constant);
}

// The node-ID, 1 to 127, is added to each of these.
INSTANTIATE_TEST_SUITE_P(CobIds, ChangedPdoRecord,
                         testing::Values(Change{0x1400, 1, 0x180, true},
                                         Change{0x1400, 1, 0x500, true},
                                         Change{0x1400, 1, 0x580, false},        // SDO
                                         Change{0x1400, 1, 0x600, false},        // SDO
                                         Change{0x1400, 1, 0x660, false},        // 6DFh for 127
                                         Change{0x1400, 1, 0x700, false},        // error control
                                         Change{0x1400, 1, 0x000, false},        // 001h to 07Fh
                                         Change{0x1400, 1, 0x100, false},        // 101h to 180h
                                         Change{0x1400, 1, 0x2000'0200, false},  // 29 bits
                                         Change{0x1400, 1, 0x8000'0580, true},   // no PDO
                                         Change{0x1800, 1, 0x4000'0180, true},
                                         Change{0x1800, 1, 0x580, false},
                                         Change{0x1800, 1, 0x8000'0000, true}));
INSTANTIATE_TEST_SUITE_P(
    TransmissionTypes, ChangedPdoRecord,
    testing::Values(Change{0x1400, 2, 240, true}, Change{0x1400, 2, 241, false},
                    Change{0x1400, 2, 252, false}, Change{0x1400, 2, 253, false},
                    Change{0x1400, 2, 254, true}, Change{0x1800, 2, 0, true},
                    Change{0x1800, 2, 240, true}, Change{0x1800, 2, 241, false},
                    Change{0x1800, 2, 251, false}, Change{0x1800, 2, 252, true},
                    Change{0x1800, 2, 253, true}));
INSTANTIATE_TEST_SUITE_P(
    MappedObjects, ChangedPdoRecord,
    testing::Values(Change{0x1600, 1, 0x2000'06'10, false},  // no such sub-index
                    Change{0x1600, 1, 0x3000'01'10, false},  // no such object
                    Change{0x1600, 1, 0x2000'01'08, false},  // other bits
                    Change{0x1600, 1, 0x2000'01'00, false},
                    Change{0x1600, 1, 0x2001'00'10, false},  // cannot be mapped
                    Change{0x1600, 4, 0x0005'00'08, true},   // dummy
                    Change{0x1600, 4, 0x0006'00'08, false},  // other bits
                    Change{0x1600, 4, 0x0006'01'10, false},
                    Change{0x1600, 4, 0x0008'00'20, false},  // REAL32 is no dummy
                    Change{0x1A00, 4, 0x0006'00'10, false},  // in RPDOs only
                    Change{0x1A00, 1, 0x2001'00'10, false}, Change{0x1A00, 1, 0x2000'05'10, true}));
INSTANTIATE_TEST_SUITE_P(Counts, ChangedPdoRecord,
                         testing::Values(Change{0x1600, 0, 0, true}, Change{0x1600, 0, 3, true},
                                         Change{0x1600, 0, 5, false},  // 80 bits
                                         Change{0x1A00, 0, 5, false},
                                         Change{0x1A00, 0, 6, false},  // no sub-index 6
                                         Change{0x1A00, 0, 65, false},
                                         Change{0x1A00, 0, 254, false},  // multiplexed
                                         Change{0x1A00, 0, 255, false}));

TEST(PdoRecords, AreWritableWhereAnyEntryOfTheirDirectionIs) {
  const DictionaryTables tables = layout.tables();
  for (const ObjectRow& object : tables.objects.first(4)) {
    for (unsigned i = 0; i < object.entry_count; ++i) {
      Rows rows = described_rows;
      rows.at(object.entry_first + i).access = Access::rw;
      EXPECT_EQ(records_of(rows, object.index), PdoRecords::writable) << object.index << " " << i;
      const unsigned other = object.index < 0x1800 ? 0x1800 : 0x1400;
      EXPECT_EQ(records_of(rows, other), PdoRecords::constant) << object.index << " " << i;
    }
  }
}

TEST(PdoRecords, AreLeftToTheChecksAtRunTimeWhereObjectsChangeTheirPlace) {
  DictionaryTables tables = layout.tables();
  tables.index_in_tables = [](const Dictionary&, std::uint16_t index) { return index; };
  EXPECT_EQ(pdo_records(tables, PdoDirection::receive), PdoRecords::writable);
  EXPECT_EQ(pdo_records(tables, PdoDirection::transmit), PdoRecords::writable);
}

}  // namespace
}  // namespace canvoy::pdo_records_test
