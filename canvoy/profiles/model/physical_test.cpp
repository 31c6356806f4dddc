#include "canvoy/profiles/model/physical.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::physical_test {
namespace {

Reading read(const EntryInfo& entry, std::vector<std::uint8_t> bytes) {
  static std::vector<std::uint8_t> kept;
  kept = std::move(bytes);
  return read_value(entry, kept);
}

TEST(Physical, ANumberIsReadInItsUnit) {
  const Reading reading = read(cia419::battery_temperature_object.entry, {0xAC, 0x00});
  EXPECT_EQ(reading.kind, Reading::Kind::number);
  EXPECT_EQ(reading.number, 21.5);
  EXPECT_EQ(reading.raw, 172);
  EXPECT_EQ(reading.value->unit, Unit::degree_celsius);
  EXPECT_FALSE(reading.out_of_range);
}

TEST(Physical, ASentinelIsReadAsItsName) {
  const Reading reading = read(cia419::battery_temperature_object.entry, {0xFF, 0xFF});
  EXPECT_EQ(reading.kind, Reading::Kind::name);
  EXPECT_EQ(reading.named->name, "invalid");
  EXPECT_EQ(reading.named->meaning, Meaning::invalid);
}

constexpr Piece rising_and_falling[] = {
    {.first = 0, .last = 100, .scale = {.denominator = 10}},
    {.first = 101, .last = 200, .scale = {.numerator = -1, .offset = 100}}};
constexpr EntryInfo falling_entry = {
    .value = {.limits = within(0, 200), .pieces = rising_and_falling}};

TEST(Physical, ANumberIsReadInTheScaleOfItsPiece) {
  EXPECT_EQ(read(falling_entry, {100}).number, 10.0);
  EXPECT_EQ(read(falling_entry, {101}).number, -1.0);
}

TEST(Physical, AStateIsReadAsItsName) {
  const EntryInfo& entry = cia419::charger_status_object.entry;
  const std::uint8_t ready[] = {0x81};  // with a reserved bit
  const Reading reading = read_field(entry, entry.fields[0], ready);
  EXPECT_EQ(reading.kind, Reading::Kind::name);
  EXPECT_EQ(reading.named->name, "ready");
  EXPECT_EQ(reading.raw, 1);
}

TEST(Physical, ANumberBeyondItsLimitsIsMarked) {
  EXPECT_TRUE(read(cia419::battery_state_of_charge_object.entry, {101}).out_of_range);
  EXPECT_FALSE(read(cia419::battery_state_of_charge_object.entry, {100}).out_of_range);
  EXPECT_FALSE(read(cia419::battery_state_of_charge_object.entry, {0xFF}).out_of_range);
  EXPECT_TRUE(read(cia419::battery_temperature_object.entry, {0xA9, 0x02}).out_of_range);
  EXPECT_FALSE(read(cia419::battery_temperature_object.entry, {0xA8, 0x02}).out_of_range);
}

TEST(Physical, BytesOfAnotherLengthAreNoValue) {
  EXPECT_EQ(read(cia419::battery_temperature_object.entry, {1}).kind, Reading::Kind::none);
  EXPECT_EQ(read(cia419::battery_temperature_object.entry, {1, 2, 3}).kind, Reading::Kind::none);
  EXPECT_EQ(read(cia419::battery_temperature_object.entry, {}).kind, Reading::Kind::none);
  const EntryInfo& status = cia419::charger_status_object.entry;
  EXPECT_EQ(read_field(status, status.fields[0], {}).kind, Reading::Kind::none);
}

TEST(Physical, ATextEndsAtItsFirstZero) {
  const Reading reading = read(cia301::device_name_object.entry, {'a', 'b', 0, 'c'});
  EXPECT_EQ(reading.kind, Reading::Kind::text);
  EXPECT_EQ(reading.text, "ab");
  EXPECT_EQ(read(cia301::device_name_object.entry, {}).text, "");
}

TEST(Physical, OctetsDomainsAndTimesAreBytes) {
  for (const DataType type : {DataType::octet_string, DataType::domain, DataType::time_of_day}) {
    const EntryInfo entry = {.type = type, .capacity = 8};
    EXPECT_EQ(read(entry, {1, 2, 3, 4, 5, 6}).kind, Reading::Kind::bytes);
  }
}

TEST(Physical, RealsAreReadAsNumbers) {
  const EntryInfo single = {.type = DataType::real32};
  EXPECT_EQ(read(single, {0x00, 0x00, 0xC0, 0x3F}).number, 1.5);
  const EntryInfo twofold = {.type = DataType::real64, .value = {.scale = {.denominator = 10}}};
  EXPECT_EQ(read(twofold, {0, 0, 0, 0, 0, 0, 0xF8, 0x3F}).number, 0.15);
  EXPECT_EQ(read(twofold, {0, 0, 0, 0}).kind, Reading::Kind::none);
}

TEST(Physical, ABooleanIsTrueForAnyValueBut0) {
  const EntryInfo entry = {.type = DataType::boolean};
  EXPECT_EQ(read(entry, {0x02}).raw, 1);
  EXPECT_EQ(read(entry, {0x00}).raw, 0);
}

Result<std::uint64_t> raw(const EntryInfo& entry, double physical) {
  return raw_from_physical(entry.value, bits_of(entry), physical);
}

TEST(Physical, WhatAPersonTypesIsRoundedToTheNearestStep) {
  EXPECT_EQ(*raw(cia419::battery_temperature_object.entry, 21.52), 172U);
  EXPECT_EQ(*raw(cia419::battery_temperature_object.entry, -40), 0xFEC0U);
  EXPECT_EQ(*raw(cia419::battery_voltage_object.entry, 24), 24576U);
}

TEST(Physical, WhatCannotBeSentIsRefused) {
  const EntryInfo& temperature = cia419::battery_temperature_object.entry;
  EXPECT_EQ(raw(temperature, 4096).abort(), AbortCode::value_too_high);
  EXPECT_EQ(raw(temperature, -4097).abort(), AbortCode::value_too_low);
  EXPECT_EQ(raw(temperature, -0.125).abort(), AbortCode::value_range) << "it would read as invalid";
  EXPECT_TRUE(raw(temperature, -0.25));
  const EntryInfo& charge = cia419::battery_state_of_charge_object.entry;
  EXPECT_EQ(raw(charge, 101).abort(), AbortCode::value_too_high);
  EXPECT_EQ(raw(charge, 255).abort(), AbortCode::value_too_high) << "the sentinel has a name";
  EXPECT_EQ(raw(charge, -1).abort(), AbortCode::value_too_low);
  EXPECT_TRUE(raw(charge, 100));
  EXPECT_FALSE(raw(charge, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(raw(charge, std::numeric_limits<double>::infinity()));
}

TEST(Physical, WhatNoPieceReachesIsRefused) {
  EXPECT_EQ(*raw(falling_entry, -100), 200U);
  EXPECT_EQ(raw(falling_entry, 10.1).abort(), AbortCode::value_too_high);
  EXPECT_EQ(raw(falling_entry, -101).abort(), AbortCode::value_too_low);
}

TEST(Physical, AFieldHasTheRangeOfItsBits) {
  const EntryInfo& entry = cia301::consumer_heartbeat_object.subs[1];
  const FieldInfo& time = entry.fields[0];
  EXPECT_EQ(*raw_from_physical(time.value, bits_of(time), 65535), 65535U);
  EXPECT_EQ(raw_from_physical(time.value, bits_of(time), 65536).abort(), AbortCode::value_too_high);
  const std::uint8_t node_5_1500_ms[] = {0xDC, 0x05, 0x05, 0x00};
  EXPECT_EQ(read_field(entry, time, node_5_1500_ms).number, 1500.0);
  EXPECT_EQ(read_field(entry, entry.fields[1], node_5_1500_ms).number, 5.0);
}

}  // namespace
}  // namespace canvoy::physical_test
