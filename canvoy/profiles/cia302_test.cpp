// The expectations are those of the profile database of CiA's conformance test.
#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia302_test {
namespace {

using namespace entry_rows;

constexpr auto manager =
    describe(cia301::device_type(0), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia302::configuration(), cia302::store_dcf_object,
             cia302::dcf_format_object, cia302::slave_eds_object, cia302::slave_eds_format_object);
constexpr auto manager_layout = lay_out_device<manager>();

constexpr Expected entries[] = {
    {0x1F20, 0, u8, "const", 127}, {0x1F20, 1, domain, "rw", 0},   {0x1F20, 127, domain, "rw", 0},
    {0x1F21, 0, u8, "const", 127}, {0x1F21, 127, u8, "rw", 0},     {0x1F22, 0, u8, "const", 127},
    {0x1F22, 1, domain, "rw", 0},  {0x1F22, 127, domain, "rw", 0}, {0x1F23, 127, domain, "rw", 0},
    {0x1F24, 127, u8, "rw", 0},    {0x1F25, 0, u8, "const", 128},  {0x1F25, 1, u32, "wo", 0},
    {0x1F25, 128, u32, "wo", 0},   {0x1F26, 0, u8, "const", 127},  {0x1F26, 127, u32, "rw", 0},
    {0x1F27, 0, u8, "const", 127}, {0x1F27, 127, u32, "rw", 0},
};

TEST(Cia302, ConfigurationObjectsHaveTheirTypesAccessAndDefaults) {
  const DeviceMemory device(manager_layout.tables(), 9);
  expect_entries(device.dictionary, entries);
  EXPECT_EQ(device.dictionary.find(0x1F22, 128).abort(), AbortCode::no_sub_index);
  EXPECT_EQ(device.dictionary.find(0x1F25, 129).abort(), AbortCode::no_sub_index);
}

constexpr auto sdo_manager = describe(cia301::device_type(0), cia301::error_register_object,
                                      cia301::identity({.vendor_id = 1}), cia301::sdo_servers(1),
                                      cia302::sdo_manager(32, 16), cia302::sdo_requester(2));
constexpr auto sdo_manager_layout = lay_out_device<sdo_manager>();
constexpr Expected sdo_manager_entries[] = {
    {0x1280, 1, u32, "rw", 0x8000'0000},
    {0x1282, 3, u8, "rw", 0},
    {0x1F00, 0, u32, "wo", 0},
    {0x1F01, 0, u32, "wo", 0},
    {0x1F02, 0, u8, "const", 32},
    {0x1F02, 1, u32, "rw", 0x8000'0000},
    {0x1F02, 32, u32, "rw", 0x8000'0000},
    {0x1F03, 0, u8, "const", 16},
    {0x1F03, 16, u32, "ro", 0},
    {0x1F10, 0, u32, "rw", 0},
};

TEST(Cia302, SdoManagerObjectsHaveTheirTypesAccessAndDefaults) {
  const DeviceMemory device(sdo_manager_layout.tables(), 9);
  expect_entries(device.dictionary, sdo_manager_entries);
  EXPECT_EQ(device.dictionary.find(0x1F04, 0).abort(), AbortCode::no_object);
  EXPECT_EQ(device.dictionary.find(0x1283, 0).abort(), AbortCode::no_object);
}

TEST(Cia302, ObjectsAreInTheOrderOfTheirIndices) {
  for (std::size_t i = 1; i < cia302::profile.objects.size(); ++i) {
    const ObjectInfo& last = *cia302::profile.objects[i - 1];
    EXPECT_LT(last.index + last.count - 1, cia302::profile.objects[i]->index);
  }
}

TEST(Cia302, ToolsKnowItsObjectsInNodesOfAllProfiles) {
  for (const Profile* profile : all_profiles()) {
    ASSERT_NE(find_description(*profile, 0x1F22), nullptr);
    EXPECT_EQ(find_description(*profile, 0x1F22)->name, "Concise DCF");
    EXPECT_EQ(find_description(*profile, 0x1F06)->name, "SDO connections");
    const auto address = find_address(*profile, "dynamic sdo connection state");
    ASSERT_TRUE(address);
    EXPECT_EQ(address->index, 0x1F10);
    EXPECT_EQ(find_description(*profile, 0x1F30), nullptr);
  }
}

constexpr auto slave = describe(cia301::device_type(0), cia301::error_register_object,
                                cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(0),
                                cia301::verify_configuration_object);
constexpr auto slave_layout = lay_out_device<slave>();

TEST(Cia302, ADeviceWith1020hForgetsItsDateWhenItsConfigurationChanges) {
  Cable cable;
  DeviceNode<slave_layout> device(cable.port(0), 5);
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("605#23 20 10 01 E8 03 00 00");
  EXPECT_EQ(device.dictionary().number(0x1020, 1), 1000u);
  cable.send("605#2B 17 10 00 00 00 00 00");
  EXPECT_EQ(device.dictionary().number(0x1020, 1), 0u);
}

}  // namespace
}  // namespace canvoy::cia302_test
