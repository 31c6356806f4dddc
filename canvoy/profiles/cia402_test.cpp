// Facts upon which public sources agree; CiA 402 itself is not at hand.
#include "canvoy/profiles/cia402.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia402/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/described.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia402_test {
namespace {

constexpr DataType u8 = DataType::unsigned8, u16 = DataType::unsigned16, u32 = DataType::unsigned32,
                   i8 = DataType::integer8, i16 = DataType::integer16, i32 = DataType::integer32,
                   text = DataType::visible_string;

TEST(Cia402, ObjectsHaveTheirTypesAndDefaults) {
  expect_described(cia402::profile, {{0x6007, i16},    {0x603F, u16},
                                     {0x6040, u16},    {0x6041, u16},
                                     {0x605A, i16, 2}, {0x605B, i16, 0},
                                     {0x605C, i16, 1}, {0x605D, i16, 1},
                                     {0x605E, i16, 2}, {0x6060, i8},
                                     {0x6061, i8},     {0x6064, i32},
                                     {0x6065, u32},    {0x6066, u16},
                                     {0x6067, u32},    {0x6068, u16},
                                     {0x6069, i32},    {0x606A, i16},
                                     {0x606B, i32},    {0x606C, i32},
                                     {0x606D, u16},    {0x606E, u16},
                                     {0x606F, u16},    {0x6070, u16},
                                     {0x6071, i16},    {0x6072, u16},
                                     {0x6073, u16},    {0x6074, i16},
                                     {0x6075, u32},    {0x6076, u32},
                                     {0x6077, i16},    {0x6078, i16},
                                     {0x6079, u32},    {0x607A, i32},
                                     {0x607B, i32},    {0x607C, i32},
                                     {0x607D, i32},    {0x607E, u8},
                                     {0x607F, u32},    {0x6080, u32},
                                     {0x6081, u32},    {0x6082, u32},
                                     {0x6083, u32},    {0x6084, u32},
                                     {0x6085, u32},    {0x6086, i16},
                                     {0x6087, u32},    {0x608F, u32},
                                     {0x6090, u32},    {0x6091, u32},
                                     {0x6092, u32},    {0x6098, i8},
                                     {0x6099, u32},    {0x609A, u32},
                                     {0x60A3, u8},     {0x60A4, u32},
                                     {0x60C5, u32},    {0x60C6, u32},
                                     {0x60F4, i32},    {0x60F8, i32},
                                     {0x60FA, i32},    {0x60FC, i32},
                                     {0x60FD, u32},    {0x60FE, u32},
                                     {0x60FF, i32},    {0x6402, u16},
                                     {0x6403, text},   {0x6404, text},
                                     {0x6405, text},   {0x6406, DataType::time_of_day},
                                     {0x6502, u32}});
}

TEST(Cia402, ArraysHaveTheirEntries) {
  for (unsigned index : {0x607BU, 0x607DU, 0x608FU, 0x6092U, 0x6099U, 0x60FEU}) {
    EXPECT_NE(find_entry(*find_object(cia402::profile, index), 2), nullptr) << index;
    EXPECT_EQ(find_entry(*find_object(cia402::profile, index), 3), nullptr) << index;
  }
  EXPECT_NE(find_entry(*find_object(cia402::profile, 0x60A4), 6), nullptr);
  EXPECT_EQ(find_entry(*find_object(cia402::profile, 0x60A4), 7), nullptr);
}

/// All objects of CiA 402 that CiA 417-4 names in its clauses 4.11.1 to 4.11.6.
TEST(Cia402, WhatCia417PointsToIsThere) {
  for (unsigned index :
       {0x6040U, 0x6041U, 0x605AU, 0x605BU, 0x605CU, 0x605DU, 0x605EU, 0x6060U, 0x6061U,
        0x6069U, 0x606AU, 0x606BU, 0x606CU, 0x606DU, 0x606EU, 0x606FU, 0x6070U, 0x607AU,
        0x607BU, 0x607CU, 0x607DU, 0x607EU, 0x607FU, 0x6080U, 0x6081U, 0x6082U, 0x6083U,
        0x6084U, 0x6085U, 0x6086U, 0x6089U, 0x608AU, 0x608BU, 0x608CU, 0x608DU, 0x608EU,
        0x608FU, 0x6090U, 0x6091U, 0x6092U, 0x6093U, 0x6094U, 0x6095U, 0x6096U, 0x6097U,
        0x60C5U, 0x60C6U, 0x60F8U, 0x60F9U, 0x60FAU, 0x60FFU}) {
    EXPECT_NE(find_object(cia402::profile, index), nullptr) << std::hex << index;
  }
}

TEST(Cia402, TheStatuswordTellsTheState) {
  using cia402::DriveState;
  struct {
    std::uint16_t mask;
    std::uint16_t value;
    DriveState state;
  } constexpr patterns[] = {{0x4F, 0x00, DriveState::not_ready_to_switch_on},
                            {0x4F, 0x40, DriveState::switch_on_disabled},
                            {0x6F, 0x21, DriveState::ready_to_switch_on},
                            {0x6F, 0x23, DriveState::switched_on},
                            {0x6F, 0x27, DriveState::operation_enabled},
                            {0x6F, 0x07, DriveState::quick_stop_active},
                            {0x4F, 0x0F, DriveState::fault_reaction_active},
                            {0x4F, 0x08, DriveState::fault}};
  for (unsigned statusword = 0; statusword <= 0xFFFF; ++statusword) {
    for (const auto& [mask, value, state] : patterns) {
      if ((statusword & mask) != value) continue;
      ASSERT_EQ(cia402::drive_state(static_cast<std::uint16_t>(statusword)), state)
          << std::hex << statusword;
    }
  }
}

const FieldInfo* field_at(unsigned index, unsigned bit) {
  for (const FieldInfo& field : find_object(cia402::profile, index)->entry.fields) {
    if (bit >= field.first_bit && bit < field.first_bit + unsigned{field.bits}) return &field;
  }
  return nullptr;
}

TEST(Cia402, BitsOfControlwordAndStatuswordHaveTheirNames) {
  EXPECT_EQ(field_at(0x6040, 0)->name, "Switch on");
  EXPECT_EQ(field_at(0x6040, 1)->name, "Enable voltage");
  EXPECT_EQ(field_at(0x6040, 2)->name, "Quick stop");
  EXPECT_EQ(field_at(0x6040, 3)->name, "Enable operation");
  EXPECT_EQ(field_at(0x6040, 7)->name, "Fault reset");
  EXPECT_EQ(field_at(0x6040, 8)->name, "Halt");
  EXPECT_EQ(field_at(0x6040, 15)->name, "Manufacturer-specific");
  EXPECT_EQ(field_at(0x6041, 3)->name, "Fault");
  EXPECT_EQ(field_at(0x6041, 4)->name, "Voltage enabled");
  EXPECT_EQ(field_at(0x6041, 6)->name, "Switch on disabled");
  EXPECT_EQ(field_at(0x6041, 9)->name, "Remote");
  EXPECT_EQ(field_at(0x6041, 10)->name, "Target reached");
  EXPECT_EQ(field_at(0x6041, 11)->name, "Internal limit active");
  for (unsigned bit = 0; bit < 16; ++bit) {
    EXPECT_NE(field_at(0x6040, bit), nullptr) << bit;
    EXPECT_NE(field_at(0x6041, bit), nullptr) << bit;
  }
}

TEST(Cia402, ASupportedModeHasTheBitBelowItsNumber) {
  const ValueInfo& modes = find_object(cia402::profile, 0x6060)->entry.value;
  for (const FieldInfo& field : find_object(cia402::profile, 0x6502)->entry.fields) {
    const NamedValue* mode = find_name(modes, field.first_bit + 1, 8, true);
    ASSERT_NE(mode, nullptr);
    EXPECT_EQ(mode->name, field.name);
  }
}

constexpr auto drive_parts =
    describe(cia402::controlword_object, cia402::statusword_object,
             cia402::modes_of_operation_object, cia402::quick_stop_option_code_object,
             cia402::polarity_object, cia402::gear_ratio_object, cia402::target_torque_object,
             cia402::motor_rated_current_object, cia402::software_position_limit_object);
constexpr auto drive_layout = lay_out_device<drive_parts>();

TEST(Cia402, HandlesReachWholeValues) {
  DeviceMemory memory(drive_layout.tables());
  Values drive(memory.dictionary);
  drive[cia402::modes_of_operation] = cia402::DriveMode::profile_velocity;
  EXPECT_EQ(memory.dictionary.number(0x6060, 0), 3U);
  EXPECT_TRUE(drive[cia402::quick_stop_option_code].is(cia402::StopReaction::quick_stop_ramp));
  drive[cia402::target_torque] = -500;  // per mille
  EXPECT_EQ(memory.dictionary.number(0x6071, 0), 0xFE0CU);
  drive[cia402::motor_rated_current] = Amperes(12.5);
  EXPECT_EQ(memory.dictionary.number(0x6075, 0), 12500U);
  drive[cia402::gear_ratio_shaft_revolutions] = 7;
  EXPECT_EQ(memory.dictionary.number(0x6091, 1), 1U);
  EXPECT_EQ(memory.dictionary.number(0x6091, 2), 7U);
  drive[cia402::max_position_limit] = -1;
  EXPECT_EQ(memory.dictionary.number(0x607D, 2), 0xFFFF'FFFFU);
}

TEST(Cia402, HandlesReachSingleBits) {
  DeviceMemory memory(drive_layout.tables());
  Values drive(memory.dictionary);
  drive[cia402::switch_on] = true;
  drive[cia402::enable_voltage] = true;
  drive[cia402::no_quick_stop] = true;
  drive[cia402::enable_operation] = true;
  EXPECT_EQ(memory.dictionary.number(0x6040, 0),
            static_cast<unsigned>(cia402::DriveCommand::enable_operation));
  drive[cia402::halt] = true;
  drive[cia402::fault_reset] = true;
  EXPECT_EQ(memory.dictionary.number(0x6040, 0), 0x018FU);
  drive[cia402::statusword] = 0x0408;
  EXPECT_TRUE(drive[cia402::fault].is_set());
  EXPECT_TRUE(drive[cia402::target_reached].is_set());
  EXPECT_FALSE(drive[cia402::remote].is_set());
  drive[cia402::position_reversed] = true;
  EXPECT_EQ(memory.dictionary.number(0x607E, 0), 0x80U);
}

}  // namespace
}  // namespace canvoy::cia402_test
