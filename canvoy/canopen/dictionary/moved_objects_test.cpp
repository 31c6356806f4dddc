// Objects with other indices on the bus than in the tables: every service with an index from the
// bus finds them there, and nothing at the index of the tables (DictionaryTables).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::moved_objects_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

/// Objects 2000h to 20FFh of the tables are at 3000h to 30FFh.
std::uint16_t in_tables(const Dictionary&, std::uint16_t index) {
  if (index >= 0x2000 && index <= 0x20FF) return 0;
  const bool is_moved = index >= 0x3000 && index <= 0x30FF;
  return static_cast<std::uint16_t>(is_moved ? index - 0x1000 : index);
}
constexpr DictionaryTables moved_tables = [] {
  DictionaryTables tables = mpdo_tables;
  tables.index_in_tables = in_tables;
  return tables;
}();

struct MovedNode : MpdoNode {
  MovedNode() : MpdoNode(Tpdos::AtStart::wait_for_event, 5, moved_tables) {}
};

TEST(MovedObjects, AreFoundInTheirNewPlaceAloneAndByTheirOldOneFromInside) {
  MovedNode node;
  const Dictionary& dictionary = node.node.dictionary();
  EXPECT_TRUE(dictionary.find_for_bus(0x3010, 8));
  EXPECT_EQ(dictionary.find_for_bus(0x3010, 9).abort(), no_sub_index);
  EXPECT_EQ(dictionary.find_for_bus(0x2010, 1).abort(), no_object);
  EXPECT_TRUE(dictionary.find_for_bus(0x1800, 1)) << "others stay";
  EXPECT_TRUE(dictionary.find(0x2010, 8));
  EXPECT_FALSE(dictionary.find(0x3010, 8));
  EXPECT_EQ(dictionary.find_for_bus(0x3010, 1)->index, 0x2010) << "as hooks know it";
}

TEST(MovedObjects, AreMappedByTheirNewIndex) {
  MovedNode node;
  ASSERT_EQ(node.write(0x1800, 1, 0x8000'0185), none);
  EXPECT_EQ(node.write(0x1A00, 1, 0x2010'0110), no_object);
  EXPECT_EQ(node.write(0x1A00, 1, 0x3010'0110), none);
  EXPECT_EQ(node.write(0x1A00, 0, 1), none);
  ASSERT_EQ(node.write(0x1800, 1, 0x185), none);
  node.operate();
  node.set(0x2010, 1, 0x1234);
  node.expect({"185#34 12"});
}

TEST(MovedObjects, TakeMpdosInDestinationAddressModeByTheirNewIndex) {
  MovedNode node;
  node.use_rpdo(1, 0x205, 0xFF);
  node.operate();
  node.receive("205#85 10 30 03 34 12 00 00");
  EXPECT_EQ(node.number(0x2010, 3), 0x1234U);
  EXPECT_EQ(node.errors(), Texts());
  node.receive("205#85 10 20 03 FF FF 00 00");
  EXPECT_EQ(node.number(0x2010, 3), 0x1234U);
  EXPECT_EQ(node.errors(), Texts({"+8230/1"}));
}

TEST(MovedObjects, StandInDispatchingListsByTheirNewIndex) {
  MovedNode node;
  EXPECT_EQ(node.write(0x1FD0, 1, 0x01'2010'03'6000'01'07), no_object);
  node.fill_list(0x1FD0, {0x01'3010'03'6000'01'07});
  node.use_rpdo(1, 0x205, 0xFE);
  node.operate();
  node.receive("205#07 00 60 01 34 12 00 00");
  EXPECT_EQ(node.number(0x2010, 3), 0x1234U);
}

TEST(MovedObjects, StandInScannerListsAndAreSentByTheirNewIndex) {
  MovedNode node;
  node.fill_list(0x1FA0, {0x01'3010'03});
  node.use_tpdo(1, 0x185, 0xFE);
  node.operate();
  node.set(0x2010, 3, 0x1234);
  node.expect({"185#05 10 30 03 34 12 00 00"});
}

}  // namespace
}  // namespace canvoy::moved_objects_test
