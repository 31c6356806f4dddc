// Facts upon which public sources agree; CiA 401 itself is not at hand.
#include "canvoy/profiles/cia401.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia401/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/described.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia401_test {
namespace {

constexpr DataType boolean = DataType::boolean, u8 = DataType::unsigned8,
                   u16 = DataType::unsigned16, u32 = DataType::unsigned32, i8 = DataType::integer8,
                   i16 = DataType::integer16, i32 = DataType::integer32, r32 = DataType::real32;

TEST(Cia401, DigitalInputsHaveTheirTypesAndDefaults) {
  expect_described(cia401::profile, {{0x6000, u8},
                                     {0x6002, u8, 0},
                                     {0x6003, u8, 0},
                                     {0x6005, boolean, 1},
                                     {0x6006, u8, 255},
                                     {0x6007, u8, 0},
                                     {0x6008, u8, 0},
                                     {0x6020, boolean},
                                     {0x6027, boolean},
                                     {0x6100, u16},
                                     {0x6102, u16, 0},
                                     {0x6103, u16, 0},
                                     {0x6106, u16, 65535},
                                     {0x6107, u16, 0},
                                     {0x6108, u16, 0},
                                     {0x6120, u32},
                                     {0x6122, u32, 0},
                                     {0x6123, u32, 0},
                                     {0x6126, u32, 0xFFFF'FFFF},
                                     {0x6127, u32, 0},
                                     {0x6128, u32, 0}});
}

TEST(Cia401, DigitalOutputsHaveTheirTypesAndDefaults) {
  expect_described(cia401::profile, {{0x6200, u8},
                                     {0x6202, u8, 0},
                                     {0x6206, u8, 255},
                                     {0x6207, u8, 0},
                                     {0x6208, u8, 255},
                                     {0x6300, u16},
                                     {0x6302, u16, 0},
                                     {0x6306, u16, 65535},
                                     {0x6307, u16, 0},
                                     {0x6308, u16, 65535},
                                     {0x6320, u32},
                                     {0x6322, u32, 0},
                                     {0x6326, u32, 0xFFFF'FFFF},
                                     {0x6327, u32, 0},
                                     {0x6328, u32, 0xFFFF'FFFF}});
}

TEST(Cia401, AnalogueInputsHaveTheirTypesAndDefaults) {
  expect_described(cia401::profile, {{0x6400, i8},
                                     {0x6401, i16},
                                     {0x6402, i32},
                                     {0x6403, r32},
                                     {0x6421, u8, 7},
                                     {0x6422, u32},
                                     {0x6423, boolean, 0},
                                     {0x6424, i32, 0},
                                     {0x6425, i32, 0},
                                     {0x6426, u32, 0},
                                     {0x6427, u32, 0},
                                     {0x6428, u32, 0},
                                     {0x6429, r32, 0},
                                     {0x642A, r32, 0},
                                     {0x642B, r32, 0},
                                     {0x642C, r32, 0},
                                     {0x642D, r32, 0},
                                     {0x642E, r32, 0},
                                     {0x642F, r32, 0x3F80'0000},
                                     {0x6430, u32},
                                     {0x6431, i32, 0},
                                     {0x6432, i32, 1}});
}

TEST(Cia401, AnalogueOutputsHaveTheirTypesAndDefaults) {
  expect_described(cia401::profile, {{0x6410, i8},
                                     {0x6411, i16},
                                     {0x6412, i32},
                                     {0x6413, r32},
                                     {0x6441, r32, 0},
                                     {0x6442, r32, 0x3F80'0000},
                                     {0x6443, u8, 1},
                                     {0x6444, i32, 0},
                                     {0x6445, r32, 0},
                                     {0x6446, i32, 0},
                                     {0x6447, i32, 1},
                                     {0x6450, u32}});
}

TEST(Cia401, PdosCarryTwelveAnalogueAnd64DigitalChannels) {
  struct {
    PdoInfo::Direction direction;
    unsigned number;
    std::uint32_t can_id;
    std::uint32_t first;
    std::size_t count;
  } constexpr expected[] = {{PdoInfo::Direction::receive, 1, 0x200, 0x6200'0108, 8},
                            {PdoInfo::Direction::receive, 2, 0x300, 0x6411'0110, 4},
                            {PdoInfo::Direction::receive, 3, 0x400, 0x6411'0510, 4},
                            {PdoInfo::Direction::receive, 4, 0x500, 0x6411'0910, 4},
                            {PdoInfo::Direction::transmit, 1, 0x180, 0x6000'0108, 8},
                            {PdoInfo::Direction::transmit, 2, 0x280, 0x6401'0110, 4},
                            {PdoInfo::Direction::transmit, 3, 0x380, 0x6401'0510, 4},
                            {PdoInfo::Direction::transmit, 4, 0x480, 0x6401'0910, 4}};
  ASSERT_EQ(cia401::profile.pdos.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    const PdoInfo& pdo = cia401::profile.pdos[i];
    EXPECT_EQ(pdo.direction, expected[i].direction);
    EXPECT_EQ(pdo.number, expected[i].number);
    EXPECT_EQ(pdo.cob_id, expected[i].can_id);
    EXPECT_TRUE(pdo.plus_node_id);
    ASSERT_EQ(pdo.mapping.size(), expected[i].count);
    for (std::uint32_t n = 0; n < expected[i].count; ++n) {
      EXPECT_EQ(pdo.mapping[n], expected[i].first + (n << 8));
    }
  }
}

TEST(Cia401, TheDeviceTypeSaysWhichKindsOfChannelsThereAre) {  // VIPA's module: 00050191h
  constexpr std::uint32_t vipa = 0x0005'0191;
  unsigned kinds = 0;
  for (const FieldInfo& field : cia401::profile.device_type) {
    const auto bits = vipa >> field.first_bit & 1;
    if (field.name == "Digital input" || field.name == "Analogue input") {
      EXPECT_EQ(bits, 1U);
      ++kinds;
    } else if (field.name == "Digital output" || field.name == "Analogue output") {
      EXPECT_EQ(bits, 0U);
      ++kinds;
    }
  }
  EXPECT_EQ(kinds, 4U);
}

constexpr auto module = describe(cia301::device_type(0x0001'0191), cia301::error_register_object,
                                 Part(cia401::read_input_8_bit_object).up_to(2));
constexpr auto module_layout = lay_out_device<module>();

TEST(Cia401, AModuleTakesAsManyChannelsAsItHas) {
  const DeviceMemory device(module_layout.tables());
  EXPECT_EQ(device.dictionary.number(0x6000, 0), 2U);
  EXPECT_TRUE(device.dictionary.find(0x6000, 2));
  EXPECT_FALSE(device.dictionary.find(0x6000, 3));
}

constexpr auto large_module = describe(Part(cia401::read_input_8_bit_object).up_to(2),
                                       Part(cia401::read_input_bit_object).up_to(16),
                                       Part(cia401::analogue_output_error_mode_object).up_to(4),
                                       Part(cia401::analogue_input_scaling_float_object).up_to(2),
                                       cia401::analogue_input_global_interrupt_enable_object);
constexpr auto large_layout = lay_out_device<large_module>();

TEST(Cia401, HandlesReachChannels) {
  DeviceMemory memory(large_layout.tables());
  Values values(memory.dictionary);
  values[cia401::read_input_8_bit(2)] = 0x0F;
  EXPECT_EQ(memory.dictionary.number(0x6000, 2), 0x0FU);
  values[cia401::read_input_bit(8, 12)] = true;
  EXPECT_EQ(memory.dictionary.number(0x6027, 12), 1U);
  EXPECT_EQ(memory.dictionary.number(0x6020, 12), 0U);
  values[cia401::analogue_output_error_mode(3)] = cia401::ErrorMode::keep;
  EXPECT_EQ(memory.dictionary.number(0x6443, 3), 0U);
  EXPECT_EQ(memory.dictionary.number(0x6443, 4), 1U);
  EXPECT_EQ(values[cia401::analogue_input_scaling_float(2)].value(), 1.0);
  EXPECT_FALSE(values[cia401::analogue_input_global_interrupt_enable].is_set());
}

}  // namespace
}  // namespace canvoy::cia401_test
