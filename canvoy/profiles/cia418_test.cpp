// Facts upon which public sources agree and that CiA 419 mirrors; CiA 418 itself is not at hand.
#include "canvoy/profiles/cia418.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia418_test {
namespace {

using namespace entry_rows;

constexpr auto full_battery = describe(
    cia418::battery({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
    cia418::battery_serial_number_object, cia418::battery_id_object,
    cia418::vehicle_serial_number_object, cia418::vehicle_id_object,
    cia418::cumulative_total_ah_charge_object, cia418::ah_expended_since_last_charge_object,
    cia418::ah_since_last_equalization_object, cia418::date_of_last_equalization_object,
    cia418::water_level_status_object, cia301::identity({.vendor_id = 1}),
    cia301::heartbeat_producer(1000));
constexpr auto full_layout = lay_out_device<full_battery>();
constexpr auto small_battery = describe(cia418::battery(), cia301::identity({.vendor_id = 1}),
                                        cia301::heartbeat_producer(1000));
constexpr auto small_layout = lay_out_device<small_battery>();

/// Of node-ID 5.
constexpr Expected entries[] = {
    {0x1000, 0, u32, "ro", 0x000001A2},
    {0x1400, 1, u32, "rw", 0x205},
    {0x1400, 2, u8, "rw", 255},
    {0x1401, 1, u32, "rw", 0x305},
    {0x1402, 1, u32, "rw", 0x405},
    {0x1600, 0, u8, "ro", 1},
    {0x1600, 1, u32, "ro", 0x60010008},
    {0x1601, 0, u8, "ro", 2},
    {0x1601, 1, u32, "ro", 0x60010008},
    {0x1601, 2, u32, "ro", 0x60520010},
    {0x1602, 0, u8, "ro", 3},
    {0x1602, 1, u32, "ro", 0x60010008},
    {0x1602, 2, u32, "ro", 0x60520010},
    {0x1602, 3, u32, "ro", 0x60800008},
    {0x1800, 1, u32, "rw", 0x185},
    {0x1800, 2, u8, "rw", 255},
    {0x1800, 5, u16, "rw", 200},
    {0x1801, 1, u32, "rw", 0x285},
    {0x1801, 5, u16, "rw", 200},
    {0x1802, 1, u32, "rw", 0x385},
    {0x1802, 5, u16, "rw", 200},
    {0x1A00, 0, u8, "ro", 2},
    {0x1A00, 1, u32, "ro", 0x60100010},
    {0x1A00, 2, u32, "ro", 0x60000008},
    {0x1A01, 0, u8, "ro", 3},
    {0x1A01, 1, u32, "ro", 0x60100010},
    {0x1A01, 2, u32, "ro", 0x60000008},
    {0x1A01, 3, u32, "ro", 0x60600020},
    {0x1A02, 0, u8, "ro", 2},
    {0x1A02, 1, u32, "ro", 0x60700010},
    {0x1A02, 2, u32, "ro", 0x60810008},
    {0x6000, 0, u8, "ro T", 0},
    {0x6001, 0, u8, "rw TR", 0},
    {0x6010, 0, i16, "ro T", 0xFFFF},
    {0x6020, 0, u8, "const", 4},
    {0x6020, 1, u8, "ro", 0},
    {0x6020, 2, u16, "ro", 0},
    {0x6020, 3, u16, "ro", 0},
    {0x6020, 4, u16, "ro", 0},
    {0x6030, 0, u8, "const", 3},
    {0x6030, 3, u32, "ro", 0},
    {0x6031, 0, u8, "const", 5},
    {0x6040, 0, u8, "const", 5},
    {0x6041, 0, u8, "const", 5},
    {0x6041, 5, u32, "ro", 0},
    {0x6050, 0, u32, "ro", 0},
    {0x6051, 0, u16, "ro", 0xFFFF},
    {0x6052, 0, u16, "rw TR", 0xFFFF},
    {0x6053, 0, u16, "rw", 0xFFFF},
    {0x6054, 0, u8, "const", 2},
    {0x6054, 1, u16, "rw", 0},
    {0x6054, 2, u16, "rw", 0},
    {0x6060, 0, u32, "ro T", 0xFFFFFFFF},
    {0x6070, 0, u16, "ro T", 0xFFFF},
    {0x6080, 0, u8, "rw TR", 0xFF},
    {0x6081, 0, u8, "ro T", 0xFF},
    {0x6090, 0, u8, "ro", 0},
};

TEST(Cia418, ObjectsHaveTheTypesAccessAndDefaultsOfTheFacts) {
  const DeviceMemory battery(full_layout.tables(), 5);
  expect_entries(battery.dictionary, entries);
}

TEST(Cia418, TheSmallestBatteryHasTheMandatoryObjectsOnly) {
  constexpr std::uint16_t mandatory[] = {0x1000, 0x1001, 0x1017, 0x1018, 0x1400, 0x1600,
                                         0x1800, 0x1A00, 0x6000, 0x6001, 0x6010, 0x6020};
  ASSERT_EQ(small_layout.objects.size(), std::size(mandatory));
  for (std::size_t i = 0; i < std::size(mandatory); ++i) {
    EXPECT_EQ(small_layout.objects[i].index, mandatory[i]);
  }
}

TEST(Cia418, WhatABatteryTransmitsTheChargerReceivesInTheSameBits) {
  for (unsigned number = 0; number < 3; ++number) {
    for (unsigned sub = 0; sub <= 3; ++sub) {
      const EntryInfo* sent = find_entry(*find_object(cia418::profile, 0x1A00 + number), sub);
      const EntryInfo* taken = find_entry(*find_object(cia419::profile, 0x1600 + number), sub);
      ASSERT_EQ(sent == nullptr, taken == nullptr);
      if (sent != nullptr) {
        EXPECT_EQ(sent->initial.number, taken->initial.number);
      }
      sent = find_entry(*find_object(cia419::profile, 0x1A00 + number), sub);
      taken = find_entry(*find_object(cia418::profile, 0x1600 + number), sub);
      ASSERT_EQ(sent == nullptr, taken == nullptr);
      if (sent != nullptr) {
        EXPECT_EQ(sent->initial.number, taken->initial.number);
      }
    }
  }
}

TEST(Cia418, AnObjectOfBothProfilesHasTheSameTypeUnitAndScale) {
  for (const ObjectInfo* charger : cia419::profile.objects) {
    if (charger->index < 0x6000) continue;
    const ObjectInfo* battery = find_object(cia418::profile, charger->index);
    ASSERT_NE(battery, nullptr);
    EXPECT_EQ(battery->entry.type, charger->entry.type);
    EXPECT_EQ(battery->entry.value.unit, charger->entry.value.unit);
    EXPECT_EQ(battery->entry.value.scale, charger->entry.value.scale);
    EXPECT_NE(allows(battery->entry.access, Access::sdo_write),
              allows(charger->entry.access, Access::sdo_write))
        << "the one who produces a value has it ro, the other rw: " << charger->name;
  }
}

TEST(Cia418, ADeviceThatKnowsBetterChangesWhatIsUncertain) {
  static constexpr auto device =
      describe(cia418::battery({.tpdo3 = true})
                   .initial(cia418::tpdo3_parameter_object, 1, plus_node_id(0x8000'0380))
                   .initial(cia418::tpdo1_parameter_object, 5, 1000),
               cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000));
  static constexpr auto layout = lay_out_device<device>();
  const DeviceMemory battery(layout.tables(), 0x7F);
  EXPECT_EQ(battery.dictionary.number(0x1802, 1), 0x8000'03FFU);
  EXPECT_EQ(battery.dictionary.number(0x1800, 5), 1000U);
  EXPECT_EQ(battery.dictionary.number(0x1802, 5), 200U);
}

TEST(Cia418, ParametersAreAmpereHoursAmperesAndCells) {
  DeviceMemory memory(small_layout.tables());
  Values battery(memory.dictionary);
  battery[cia418::battery_type] = 0xA0;
  battery[cia418::capacity] = 230;
  battery[cia418::maximum_charge_current] = 45;
  battery[cia418::number_of_cells] = 24;
  EXPECT_EQ(memory.dictionary.number(0x6020, 1), 0xA0U);
  EXPECT_EQ(memory.dictionary.number(0x6020, 2), 230U);
  EXPECT_EQ(memory.dictionary.number(0x6020, 3), 45U);
  EXPECT_EQ(memory.dictionary.number(0x6020, 4), 24U);
}

TEST(Cia418, SerialNumbersArePackedFourCharactersInANumber) {
  DeviceMemory memory(full_layout.tables());
  Values battery(memory.dictionary);
  std::array<char, 12> buffer{};
  EXPECT_EQ(battery[cia418::battery_serial_number].value(buffer), "");
  battery[cia418::battery_serial_number] = "AB-12345";
  EXPECT_EQ(memory.dictionary.number(0x6030, 1), 0x312D'4241U);  // 'A' first
  EXPECT_EQ(memory.dictionary.number(0x6030, 2), 0x3534'3332U);
  EXPECT_EQ(memory.dictionary.number(0x6030, 3), 0U);
  EXPECT_EQ(battery[cia418::battery_serial_number].value(buffer), "AB-12345");
  battery[cia418::battery_serial_number] = "123456789ABCDEF";
  EXPECT_EQ(battery[cia418::battery_serial_number].value(buffer), "123456789ABC");
}

TEST(Cia418, TheSecondBatteryStands800hAboveTheFirst) {
  EXPECT_EQ(find_object(cia418::profile, 0x6810), &cia418::temperature_object);
  EXPECT_EQ(find_object(cia418::profile, 0x6010 + 7 * 0x800), &cia418::temperature_object);
  EXPECT_EQ(find_object(cia418::profile, 0x6010 + 8 * 0x800), nullptr);

  static constexpr auto device =
      describe(small_battery, Part(cia418::temperature_object).moved(0x800),
               Part(cia418::battery_status_object).moved(0x800));
  static constexpr auto layout = lay_out_device<device>();
  DeviceMemory memory(layout.tables());
  Values battery(memory.dictionary);
  battery[cia418::temperature] = 20;
  battery[cia418::temperature.shifted(0x800)] = 30;
  EXPECT_EQ(memory.dictionary.number(0x6010, 0), 160U);
  EXPECT_EQ(memory.dictionary.number(0x6810, 0), 240U);
  EXPECT_EQ(battery[cia418::temperature.shifted(0x800)].value(), 30.0);
}

}  // namespace
}  // namespace canvoy::cia418_test
