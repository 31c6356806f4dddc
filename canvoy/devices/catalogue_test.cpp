// The descriptions of the catalogue agree with the devices, at the wire.
#include "canvoy/devices/catalogue.hpp"

#include <gtest/gtest.h>

#include <set>

#include "canvoy/canopen/device/mandatory_objects.hpp"
#include "canvoy/devices/cia417/kit/device_on_cable_test.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/devices/testing/every_device.hpp"

namespace canvoy::catalogue_test {
namespace {

struct CatalogueTest : testing::TestWithParam<const DeviceKind*>,
                       cia417::DeviceOnCable<DeviceOfKind> {
  CatalogueTest() : DeviceOnCable(*GetParam()) { start(); }
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) {
    return device.node().dictionary().number(index, sub);
  }
};

TEST_P(CatalogueTest, ADeviceRunsAndHasItsProfileAndProductCode) {
  const DeviceInfo& info = GetParam()->info;
  EXPECT_EQ(device.node().state(), NmtState::operational);
  EXPECT_EQ(device.node().id(), info.node_id);
  // Profiles that are built on another one have its number.
  const Profile& profile = *GetParam()->profile;
  const std::uint64_t expected =
      profile.device_types.mask != 0 ? profile.device_types.value & 0xFFFF : profile.number;
  EXPECT_EQ(number(0x1000, 0) & 0xFFFF, expected);
  EXPECT_EQ(number(0x1018, 2), info.product_code);
  EXPECT_FALSE(ask("40 08 10 00 00 00 00 00").empty());
}

/// The source of data sheets agrees with the device.
TEST_P(CatalogueTest, ADeviceHasTheObjectsOfItsDescription) {
  std::size_t objects = 0;
  for (const Part& part : GetParam()->forms.front().parts()) {
    EXPECT_TRUE(device.node().dictionary().find(part.index(), 0)) << std::hex << part.index();
    objects += part.count();
  }
  std::size_t rows = 0;
  for (const ObjectRow& row : device.node().dictionary().tables().objects) rows += row.count;
  EXPECT_EQ(rows, objects);
}

/// Descriptions that are known at compile time would not compile otherwise; others are composed at
/// run time.
TEST_P(CatalogueTest, ADeviceLacksNothingThatCiA301WantsOfIt) {
  const MissingEntry missing = find_missing(device.node().dictionary().tables());
  EXPECT_EQ(missing.rule, "") << missing.object << ' ' << missing.entry;
}

INSTANTIATE_TEST_SUITE_P(Every, CatalogueTest, testing::ValuesIn(every_device_kind()),
                         [](const auto& each) { return test_name(*each.param); });

TEST(Catalogue, EachNameStandsForOneDevice) {
  std::set<std::string_view> names;
  for (const DeviceKind* kind : device_catalogue()) {
    EXPECT_TRUE(names.insert(kind->info.name).second) << kind->info.name;
    EXPECT_EQ(find_device_kind(kind->info.name), kind);
  }
  EXPECT_EQ(find_device_kind("boat"), nullptr);
}

TEST(Catalogue, WhoKeepsParametersHasTheObjectsForIt) {
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->keeping_forms.empty()) continue;
    Environment environment;
    environment.keeps_parameters = true;
    Cable cable;
    CatalogueDevice device(*kind, cable.port(0), kind->info.node_id, environment);
    EXPECT_TRUE(device.node().dictionary().find(0x1010, 3)) << kind->info.name;
    EXPECT_TRUE(device.node().dictionary().find(0x1011, 3)) << kind->info.name;
  }
}

struct Beam {
  int asked = 0;
  cia417::Detection seen = cia417::Detection::no;
  Node* node = nullptr;

  cia417::Detection sense(unsigned /*door*/) { return seen; }
  cia417::LightBarrierHardware hardware() {
    ++asked;
    return {.sense = callback<&Beam::sense>(*this)};
  }
  void made(cia417::LightBarrierUnit& /*unit*/, Node& of) { node = &of; }
};

TEST(Catalogue, ADeviceTakesTheHardwareOfItsSiteAndIsTold) {
  Beam beam;
  Environment environment;
  environment.door = 2;
  environment.provide(callback<&Beam::hardware>(beam));
  environment.watch(callback<&Beam::made>(beam));
  Cable cable;
  CatalogueDevice device(*find_device_kind("lift-light-barrier"), cable.port(0), 9, environment);
  EXPECT_EQ(beam.asked, 1);
  EXPECT_EQ(beam.node, &device.node());
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("000#01 00");
  cable.run_for(10ms);
  EXPECT_EQ(cable.last(0x206), "206#3F") << "door 2";
  beam.seen = cia417::Detection::yes;
  cable.run_for(10ms);
  EXPECT_EQ(cable.last(0x206), "206#7F");
}

TEST(Catalogue, TheNodeIdOfADoorGoesByItsNumber) {
  const DeviceKind& door = *find_device_kind("lift-door");
  for (const auto& [number, id] : {std::pair{1U, 6}, {2U, 7}, {3U, 8}, {4U, 12}}) {
    Environment environment;
    environment.door = number;
    EXPECT_EQ(door.node_id(environment), id);
  }
}

}  // namespace
}  // namespace canvoy::catalogue_test
