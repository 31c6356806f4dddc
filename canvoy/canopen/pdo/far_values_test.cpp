// PDOs with values beyond 64 KiB of the dictionary, which a small machine cannot have.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::far_values_test {
namespace {

/// An object with values beyond the reach of three bytes of a mapped value.
TEST(FarValues, AreMappedBehindTheFirst64KiBOfTheDictionary) {
  constexpr static auto layout =
      lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 1},
                                        {.index = 0x1600, .entry_count = 2},
                                        {.index = 0x1800, .entry_count = 1},
                                        {.index = 0x1A00, .entry_count = 2},
                                        {.index = 0x2000, .count = 300, .entry_count = 1},
                                        {.index = 0x3000, .entry_count = 1}}),
              std::to_array<EntryRow>({
                  parameter(1, DataType::unsigned32, 0x205),
                  parameter(0, DataType::unsigned8, 1),
                  parameter(1, DataType::unsigned32, 0x3000'02'10),
                  parameter(1, DataType::unsigned32, 0x185),
                  parameter(0, DataType::unsigned8, 1),
                  parameter(1, DataType::unsigned32, 0x3000'02'10),
                  {.sub_first = 1, .sub_last = 254, .type = DataType::unsigned8},
                  mappable(1, 4, DataType::unsigned16),
              }));
  static_assert(layout.value_bytes > 0x1'0000 + 8);
  constexpr static DictionaryTables tables = layout.tables();
  WireNode wire(tables, 5);
  std::array<Rpdo, 1> rpdo_memory;
  std::array<Tpdo, 1> tpdo_memory;
  std::array<MappedValue, 2> values;
  Rpdos rpdos(wire.node, rpdo_memory, std::span(values).first(1));
  Tpdos tpdos(wire.node, tpdo_memory, std::span(values).last(1), nullptr,
              Tpdos::AtStart::wait_for_event);
  wire.boot_operational();
  wire.receive("205#34 12");
  EXPECT_EQ(wire.node.dictionary().number(0x3000, 2), 0x1234U);
  EXPECT_EQ(wire.node.dictionary().number(0x3000, 1), 0U);
  wire.expect({"185#34 12"});
}

}  // namespace
}  // namespace canvoy::far_values_test
