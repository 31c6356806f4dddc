// Which objects of a described device storage keeps without power.
#include <gtest/gtest.h>

#include "canvoy/canopen/storage/parameter.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::stored_test {
namespace {

constexpr ObjectInfo speed_object = {
    .index = 0x2000,
    .name = "speed",
    .entry = {.type = DataType::unsigned16, .access = Access::rw, .mapping = Mapping::by_default}};
constexpr ObjectInfo ramp_object = {
    .index = 0x2001,
    .name = "ramp",
    .entry = {.type = DataType::unsigned16, .access = Access::rw, .mapping = Mapping::optional}};

bool is_stored(const DictionaryTables& tables, std::uint16_t index, std::uint8_t sub = 0) {
  const DeviceMemory device(tables);
  const Result<Entry> entry = device.dictionary.find(index, sub);
  EXPECT_TRUE(entry) << std::hex << index;
  return entry && is_parameter(index, *entry->row);
}

TEST(Stored, WhatPdosCarryByDefaultIsAValueOfTheProcess) {
  static constexpr auto device = describe(speed_object, ramp_object);
  static constexpr auto layout = lay_out_device<device>();
  EXPECT_FALSE(is_stored(layout.tables(), 0x2000));
  EXPECT_TRUE(is_stored(layout.tables(), 0x2001));
}

TEST(Stored, ADeviceMayDecideOtherwise) {
  static constexpr auto device =
      describe(Part(speed_object).stored(), Part(ramp_object).stored(false));
  static constexpr auto layout = lay_out_device<device>();
  EXPECT_TRUE(is_stored(layout.tables(), 0x2000));
  EXPECT_FALSE(is_stored(layout.tables(), 0x2001));
}

TEST(Stored, TheConfigurationOfAChargerIsStoredAndItsMeasurementsAreNot) {
  static constexpr auto device = describe(
      cia419::charger(), cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000),
      cia301::heartbeat_consumers(2), cia301::emergency(), cia301::error_history(4),
      cia301::tpdo({.number = 4}), cia301::storage(3));
  static constexpr auto layout = lay_out_device<device>();
  for (const std::uint16_t index : std::to_array<std::uint16_t>({0x1014, 0x1015, 0x1017})) {
    EXPECT_TRUE(is_stored(layout.tables(), index)) << std::hex << index;
  }
  EXPECT_TRUE(is_stored(layout.tables(), 0x1016, 1));
  EXPECT_TRUE(is_stored(layout.tables(), 0x1400, 1));
  EXPECT_TRUE(is_stored(layout.tables(), 0x1A03, 1));
  EXPECT_TRUE(is_stored(layout.tables(), 0x1803, 2));
  for (const std::uint16_t index :
       std::to_array<std::uint16_t>({0x1000, 0x1001, 0x1003, 0x6000, 0x6010})) {
    EXPECT_FALSE(is_stored(layout.tables(), index)) << std::hex << index;
  }
  for (const std::uint8_t sub : std::to_array<std::uint8_t>({0, 1, 2, 3})) {
    EXPECT_FALSE(is_stored(layout.tables(), 0x1010, sub));
    EXPECT_FALSE(is_stored(layout.tables(), 0x1011, sub));
  }
}

}  // namespace
}  // namespace canvoy::stored_test
