// Locations of inputs, from the smallest panel to all 65,024 of eight lifts (CiA 417-4, 4.3.1).
#include "canvoy/devices/cia417/virtual_io/io_groups.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/panel/input_panel_device.hpp"
#include "canvoy/devices/cia417/panel/panel_description.hpp"

namespace canvoy::cia417::io_groups_test {
namespace {

constexpr auto third_lift =
    describe(panel<PanelOptions{.lift = 3, .inputs = 5, .outputs = 2}>(), cia301::identity({}));
constexpr auto third_lift_layout = partial(lay_out_device<third_lift>());

TEST(IoGroups, GroupsOfLift3Begin1000hAboveThoseOfLift1) {
  static constexpr DictionaryTables tables = third_lift_layout.tables();
  const IoGroups inputs(tables, 0x6100);
  EXPECT_EQ(inputs.size(), 5u);
  EXPECT_EQ(inputs.place(0), (IoPlace{0x7100, 1}));
  EXPECT_EQ(inputs.place(4), (IoPlace{0x7100, 5}));
  EXPECT_EQ(inputs.place(5), (IoPlace{0, 0}));
  EXPECT_EQ(inputs.position({0x7100, 5}), 4u);
  EXPECT_EQ(inputs.position({0x7100, 0}), io_nowhere);
  EXPECT_EQ(inputs.position({0x7100, 6}), io_nowhere);
  EXPECT_EQ(inputs.position({0x6100, 1}), io_nowhere);
  EXPECT_EQ(IoGroups(tables, 0x6200).size(), 2u);
  EXPECT_EQ(IoGroups(tables, 0x6500).size(), 0u);
}

TEST(IoGroups, AGroupIsKnownByItsIndexInEveryLift) {
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    const bool in_a_lift = index >= 0x6000 && index <= 0x9FFF;
    const unsigned in_block = index % 0x800;
    const bool expected = in_a_lift && in_block >= 0x100 && in_block <= 0x11F;
    ASSERT_EQ(is_group_of(index, 0x6100), expected) << index;
  }
}

/// All groups of all lifts, with their first parameters.
constexpr auto everything() {
  DeviceDescription<40> parts;
  parts.add(panel<PanelOptions{.outputs = 1, .parameters = false}>());
  parts.add(cia301::identity({}));
  parts.add(virtual_input_mapping_object);
  for (unsigned lift = 0; lift < lift_count; ++lift) {
    parts.add(Part(input_group_object).moved(lift * block_pitch));
    parts.add(Part(input_parameter_1_object).moved(lift * block_pitch));
  }
  parts.add(cia301::tpdo({.number = 1, .entries = 1}));
  return parts;
}
constexpr auto full_device = everything();
constexpr auto full_layout = partial(lay_out_device<full_device>());

TEST(IoGroups, EightLiftsHave32GroupsOf254InputsEach) {
  static constexpr DictionaryTables tables = full_layout.tables();
  const IoGroups inputs(tables, 0x6100);
  EXPECT_EQ(inputs.size(), 65'024u);
  EXPECT_EQ(inputs.place(0), (IoPlace{0x6100, 1}));
  EXPECT_EQ(inputs.place(253), (IoPlace{0x6100, 254}));
  EXPECT_EQ(inputs.place(254), (IoPlace{0x6101, 1}));
  EXPECT_EQ(inputs.place(32 * 254), (IoPlace{0x6900, 1}));
  EXPECT_EQ(inputs.place(65'023), (IoPlace{0x991F, 254}));
  for (std::uint32_t position = 0; position < inputs.size(); ++position) {
    ASSERT_EQ(inputs.position(inputs.place(position)), position);
  }
}

TEST(IoGroups, ADeviceWithAllOfThemTellsTheLastOne) {
  std::vector<VirtualInput> inputs(65'024);
  inputs.back() = {.function = BasicFunction::generic, .lifts = lift_bit(8), .floor = 254};
  Cable cable;
  const auto device = std::make_unique<InputPanelDevice<full_layout>>(
      cable.port(0), NodeId{1}, InputPanelSettings{.inputs = inputs});
  cable.connect(0, device->node());
  cable.start_all();
  cable.send("601#23 00 1A 01 30 00 10 60");
  cable.send("601#2F 00 1A 00 01 00 00 00");
  cable.send("601#23 00 18 01 81 04 00 00");
  cable.send("000#01 01");
  cable.run_for(1s);
  device->unit().set_level(65'023, true, cable.now);
  cable.run_for(0ms);
  EXPECT_EQ(cable.last(0x481), "481#01 00 80 FE 00 01");
  EXPECT_EQ(device->node().dictionary().number(0x991F, 254), 0x0100'FE80'0001u);
}

}  // namespace
}  // namespace canvoy::cia417::io_groups_test
