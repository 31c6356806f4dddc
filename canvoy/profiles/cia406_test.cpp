// Facts upon which public sources agree; CiA 406 itself is not at hand.
#include "canvoy/profiles/cia406.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia406/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/testing/described.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia406_test {
namespace {

constexpr DataType u8 = DataType::unsigned8, u16 = DataType::unsigned16, u32 = DataType::unsigned32,
                   i16 = DataType::integer16, i32 = DataType::integer32;

TEST(Cia406, ObjectsHaveTheirTypes) {
  expect_described(
      cia406::profile,
      {{0x6000, u16}, {0x6001, u32}, {0x6002, u32}, {0x6003, u32}, {0x6004, u32}, {0x6005, u32},
       {0x6010, u32}, {0x6020, i32}, {0x6030, i16}, {0x6040, i16}, {0x6200, u16}, {0x6300, u8},
       {0x6301, u8},  {0x6302, u8},  {0x6310, i32}, {0x6317, i32}, {0x6320, i32}, {0x6327, i32},
       {0x6330, u16}, {0x6337, u16}, {0x6400, u8},  {0x6401, i32}, {0x6402, i32}, {0x6500, u16},
       {0x6501, u32}, {0x6502, u16}, {0x6503, u16}, {0x6504, u16}, {0x6505, u16}, {0x6506, u16},
       {0x6507, u32}, {0x6508, u32}, {0x6509, i32}, {0x650A, i32}, {0x650B, u32}, {0x650C, i32}});
}

/// All objects of CiA 406 that CiA 417-4 names in its clauses 4.9 and 4.10.
TEST(Cia406, WhatCia417PointsToIsThere) {
  for (unsigned index :
       {0x6000U, 0x6001U, 0x6003U, 0x6004U, 0x6300U, 0x6301U, 0x6302U, 0x6400U, 0x6401U, 0x6402U,
        0x6500U, 0x6501U, 0x6502U, 0x6503U, 0x6504U, 0x6505U, 0x6506U, 0x6508U, 0x6509U, 0x650AU}) {
    EXPECT_NE(find_object(cia406::profile, index), nullptr) << std::hex << index;
  }
}

TEST(Cia406, ThereAreEightCamsOfEachKindAndNoMore) {
  EXPECT_EQ(find_object(cia406::profile, 0x6318), nullptr);
  EXPECT_EQ(find_object(cia406::profile, 0x6328), nullptr);
  EXPECT_EQ(find_object(cia406::profile, 0x6338), nullptr);
}

TEST(Cia406, TheOperatingTimeIsInTenthsOfAnHour) {
  const EntryInfo& entry = find_object(cia406::profile, 0x6508)->entry;
  EXPECT_EQ(entry.value.unit, Unit::hour);
  EXPECT_EQ(NumberRules(entry.value, bits_of(entry)).physical(15), 1.5);
}

TEST(Cia406, BitsHaveTheirPlaces) {
  const auto& operating = find_object(cia406::profile, 0x6000)->entry.fields;
  EXPECT_EQ(operating[0].name, "Code sequence");
  EXPECT_EQ(operating[3].name, "Measuring direction");
  EXPECT_EQ(operating[3].first_bit, 3);
  const auto& area = find_object(cia406::profile, 0x6400)->subs[1].fields;
  EXPECT_EQ(area[0].name, "Out of range");
  EXPECT_EQ(area[1].name, "Range overflow");
  EXPECT_EQ(area[2].name, "Range underflow");
  const auto& alarms = find_object(cia406::profile, 0x6503)->entry.fields;
  EXPECT_EQ(alarms[0].name, "Position error");
  EXPECT_EQ(alarms[1].name, "Commissioning diagnostics");
}

constexpr auto encoder_parts =
    describe(cia406::operating_parameters_object, cia406::position_value_object,
             Part(cia406::speed_value_object).up_to(2), cia406::warnings_object,
             Part(cia406::cam_low_limit_object).up_to(3));
constexpr auto encoder_layout = lay_out_device<encoder_parts>();

TEST(Cia406, HandlesReachValuesChannelsAndBits) {
  DeviceMemory memory(encoder_layout.tables());
  Values encoder(memory.dictionary);
  encoder[cia406::position_value] = 0x1234'5678;
  EXPECT_EQ(memory.dictionary.number(0x6004, 0), 0x1234'5678U);
  encoder[cia406::speed_value(2)] = -7;
  EXPECT_EQ(memory.dictionary.number(0x6030, 2), 0xFFF9U);
  encoder[cia406::cam_low_limit(8, 3)] = 5;
  EXPECT_EQ(memory.dictionary.number(0x6317, 3), 5U);
  encoder[cia406::scaling_enabled] = true;
  EXPECT_EQ(memory.dictionary.number(0x6000, 0), 4U);
  encoder[cia406::battery_charge] = true;
  EXPECT_EQ(memory.dictionary.number(0x6505, 0), 0x10U);
}

}  // namespace
}  // namespace canvoy::cia406_test
