// The expectations are the defaults of CiA 301 as several independent stacks and EDS files have
// them.
#include "canvoy/profiles/cia301.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia301_test {
namespace {

using namespace entry_rows;

constexpr auto everything = describe(
    cia301::profile, cia301::device_type(0x0002'0191), cia301::error_register_object,
    cia301::manufacturer_status_object, cia301::error_history(8), cia301::sync(),
    cia301::names({.device = "Charger", .hardware_version = "1.0", .software_version = "2.3.4"}),
    cia301::guard_time_object, cia301::life_time_factor_object, cia301::storage(3),
    cia301::time_cob_id_object, cia301::high_resolution_time_object, cia301::emergency(),
    cia301::heartbeat_consumers(2), cia301::heartbeat_producer(1000),
    cia301::identity({.vendor_id = 0x11223344,
                      .product_code = 0x55,
                      .revision = 0x00010002,
                      .serial_number = 7}),
    cia301::verify_configuration_object, cia301::store_eds_object, cia301::store_format_object,
    Part(cia301::module_list_object).up_to(2), cia301::emergency_consumers(3),
    cia301::error_behavior(2), cia301::default_sdo_server_object, cia301::sdo_servers(2),
    cia301::sdo_clients(3), cia301::rpdo({.number = 1, .cob_id = plus_node_id(0x200)}),
    cia301::tpdo({.number = 5, .entries = 2, .transmission_type = 1}),
    cia301::tpdo({.number = 6, .entries = 1, .multiplexed = MpdoMode::source}),
    cia301::scanner_lists(3, 2), cia301::dispatching_lists(254));
constexpr auto layout = lay_out_device<everything>();

/// Of node-ID 9.
constexpr Expected entries[] = {
    {0x1000, 0, u32, "ro", 0x00020191}, {0x1001, 0, u8, "ro T", 0},
    {0x1002, 0, u32, "ro T", 0},        {0x1003, 0, u8, "rw", 0},
    {0x1003, 1, u32, "ro", 0},          {0x1003, 8, u32, "ro", 0},
    {0x1005, 0, u32, "rw", 0x80},       {0x1006, 0, u32, "rw", 0},
    {0x1007, 0, u32, "rw", 0},          {0x100C, 0, u16, "rw", 0},
    {0x100D, 0, u8, "rw", 0},           {0x1010, 0, u8, "const", 3},
    {0x1010, 3, u32, "rw", 1},          {0x1011, 0, u8, "const", 3},
    {0x1011, 1, u32, "rw", 1},          {0x1012, 0, u32, "rw", 0x100},
    {0x1013, 0, u32, "rw TR", 0},       {0x1014, 0, u32, "rw", 0x89},
    {0x1015, 0, u16, "rw", 0},          {0x1016, 0, u8, "const", 2},
    {0x1016, 2, u32, "rw", 0},          {0x1017, 0, u16, "rw", 1000},
    {0x1018, 0, u8, "const", 4},        {0x1018, 1, u32, "ro", 0x11223344},
    {0x1018, 2, u32, "ro", 0x55},       {0x1018, 3, u32, "ro", 0x00010002},
    {0x1018, 4, u32, "ro", 7},          {0x1019, 0, u8, "rw", 0},
    {0x1020, 0, u8, "const", 2},        {0x1020, 1, u32, "rw", 0},
    {0x1020, 2, u32, "rw", 0},          {0x1022, 0, u16, "ro", 0},
    {0x1027, 0, u8, "ro", 2},           {0x1027, 2, u16, "ro", 0},
    {0x1028, 0, u8, "const", 3},        {0x1028, 3, u32, "rw", 0x80000000},
    {0x1029, 0, u8, "const", 2},        {0x1029, 1, u8, "rw", 0},
    {0x1029, 2, u8, "rw", 0},           {0x1200, 0, u8, "const", 2},
    {0x1200, 1, u32, "const", 0x609},   {0x1200, 2, u32, "const", 0x589},
    {0x1201, 0, u8, "const", 3},        {0x1201, 1, u32, "rw", 0x80000000},
    {0x1202, 2, u32, "rw", 0x80000000}, {0x1202, 3, u8, "rw", 0},
    {0x1280, 0, u8, "const", 3},        {0x1282, 1, u32, "rw", 0x80000000},
    {0x1282, 3, u8, "rw", 0},           {0x1400, 0, u8, "const", 5},
    {0x1400, 1, u32, "rw", 0x209},      {0x1400, 2, u8, "rw", 255},
    {0x1400, 3, u16, "rw", 0},          {0x1400, 5, u16, "rw", 0},
    {0x1600, 0, u8, "rw", 0},           {0x1600, 8, u32, "rw", 0},
    {0x1804, 0, u8, "const", 6},        {0x1804, 1, u32, "rw", 0x80000000},
    {0x1804, 2, u8, "rw", 1},           {0x1804, 3, u16, "rw", 0},
    {0x1804, 5, u16, "rw", 0},          {0x1804, 6, u8, "rw", 0},
    {0x1A04, 0, u8, "rw", 0},           {0x1A04, 2, u32, "rw", 0},
    {0x1A05, 0, u8, "rw", 0xFE},        {0x1FA0, 0, u8, "const", 3},
    {0x1FA1, 3, u32, "rw", 0},          {0x1FD0, 0, u8, "const", 254},
    {0x1FD0, 254, u64, "rw", 0},
};

TEST(Cia301, CommunicationObjectsHaveTheirTypesAccessAndDefaults) {
  const DeviceMemory device(layout.tables(), 9);
  expect_entries(device.dictionary, entries);
}

TEST(Cia301, ArraysEndWhereTheDeviceSays) {
  const DeviceMemory device(layout.tables());
  constexpr std::pair<std::uint16_t, std::uint8_t> beyond[] = {
      {0x1003, 9}, {0x1010, 4}, {0x1016, 3}, {0x1027, 3}, {0x1028, 4},
      {0x1029, 3}, {0x1FA1, 4}, {0x1600, 9}, {0x1A04, 3}, {0x1200, 3}};
  for (const auto& [index, sub] : beyond) {
    EXPECT_EQ(device.dictionary.find(index, sub).abort(), AbortCode::no_sub_index)
        << std::hex << index;
  }
  for (const std::uint16_t index :
       std::to_array<std::uint16_t>({0x1203, 0x1283, 0x1401, 0x1803, 0x1806, 0x1FA2, 0x1FD1})) {
    EXPECT_EQ(device.dictionary.find(index, 0).abort(), AbortCode::no_object) << std::hex << index;
  }
}

std::string_view text(const Dictionary& dictionary, std::uint16_t index) {
  const auto bytes = dictionary.find(index, 0)->bytes();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(Cia301, NamesAreStrings) {
  const DeviceMemory device(layout.tables());
  EXPECT_EQ(text(device.dictionary, 0x1008), "Charger");
  EXPECT_EQ(text(device.dictionary, 0x1009), "1.0");
  EXPECT_EQ(text(device.dictionary, 0x100A), "2.3.4");
}

TEST(Cia301, TheEdsIsADomain) {
  const DeviceMemory device(layout.tables());
  EXPECT_EQ(device.dictionary.find(0x1021, 0)->row->type, DataType::domain);
}

constexpr auto guarded_consumer =
    describe(cia301::profile, cia301::device_type(0), cia301::error_register_object,
             cia301::identity({}), cia301::node_guarding(250, 4), cia301::time_consumer());
constexpr auto guarded_consumer_layout = lay_out_device<guarded_consumer>();
constexpr auto time_producer =
    describe(cia301::profile, cia301::device_type(0), cia301::error_register_object,
             cia301::identity({}), cia301::node_guarding(), cia301::time_producer(0x0FF));
constexpr auto time_producer_layout = lay_out_device<time_producer>();

TEST(Cia301, TimeIsConsumedOrProducedFromTheStartOnWhereTheDeviceSaysSo) {
  const DeviceMemory consumer(guarded_consumer_layout.tables());
  EXPECT_EQ(consumer.dictionary.number(0x1012, 0), 0x8000'0100U);
  const DeviceMemory producer(time_producer_layout.tables());
  EXPECT_EQ(producer.dictionary.number(0x1012, 0), 0x4000'00FFU);
}

TEST(Cia301, LifeGuardingIsOffUnlessTheDeviceHasTimesForIt) {
  const DeviceMemory guarded(guarded_consumer_layout.tables());
  EXPECT_EQ(guarded.dictionary.number(0x100C, 0), 250U);
  EXPECT_EQ(guarded.dictionary.number(0x100D, 0), 4U);
  const DeviceMemory off(time_producer_layout.tables());
  EXPECT_EQ(off.dictionary.number(0x100C, 0), 0U);
  EXPECT_EQ(off.dictionary.number(0x100D, 0), 0U);
}

TEST(Cia301, ObjectsAreInTheOrderOfTheirIndices) {
  for (std::size_t i = 1; i < cia301::profile.objects.size(); ++i) {
    const ObjectInfo& last = *cia301::profile.objects[i - 1];
    EXPECT_LT(last.index + last.count - 1, cia301::profile.objects[i]->index);
  }
}

TEST(Cia301, TimesAreInTheUnitsOfTheStandard) {
  EXPECT_EQ(cia301::producer_heartbeat_object.entry.value.unit, Unit::millisecond);
  EXPECT_EQ(cia301::sync_period_object.entry.value.unit, Unit::microsecond);
  const ValueInfo& inhibit = cia301::emergency_inhibit_object.entry.value;
  EXPECT_EQ(inhibit.unit, Unit::microsecond);
  EXPECT_EQ(to_physical(3, inhibit.scale), 300.0);
}

}  // namespace
}  // namespace canvoy::cia301_test
