// Texts about the devices of the catalogue.
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools::device_catalogue_test {
namespace {

using Names = std::vector<std::string_view>;

Names of(std::string_view name) {
  return virtual_devices_of(*find_any_device_kind(name));
}

TEST(DeviceCatalogue, NamesTheVirtualDevicesOfAKind) {
  EXPECT_EQ(of("lift-load"), Names{"load measuring unit"});
  EXPECT_EQ(of("lift-controller"),
            (Names{"call controller", "car door controller", "car drive controller"}));
  EXPECT_EQ(of("lift-car-panel"), (Names{"input panel unit", "output panel unit"}));
  EXPECT_EQ(of("charger"), Names{}) << "CiA 419 has no virtual devices";
}

TEST(DeviceCatalogue, EachDeviceOfALiftACarABusOrAnOperatorIsAVirtualDevice) {
  for (const DeviceKind* kind : all_device_kinds()) {
    const bool is_of_lift = short_name(*kind->profile) == "417-4";
    const bool is_of_car = short_name(*kind->profile) == "447-3";
    const bool is_of_bus = short_name(*kind->profile) == "407";
    const bool is_of_operator = short_name(*kind->profile) == "852";
    EXPECT_EQ(!virtual_devices_of(*kind).empty(),
              is_of_lift || is_of_car || is_of_bus || is_of_operator)
        << kind->info.name;
    EXPECT_EQ(kind->info.name.starts_with("lift-"), is_of_lift) << kind->info.name;
  }
}

TEST(DeviceCatalogue, IsListedInOneJsonObjectALine) {
  testing::internal::CaptureStdout();
  print_device_list(true);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(text.find(R"({"name":"lift-load","title":"load measuring unit of a car",)"
                      R"("profile":"417-4","virtual_devices":["load measuring unit"],)"
                      R"("node_id":13})"
                      "\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            all_device_kinds().size());
}

TEST(DeviceCatalogue, StandsInTheDocumentation) {
  std::ifstream file("docs/devices.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find(device_table()), std::string::npos)
      << "docs/devices.md wants this table:\n"
      << device_table();
}

}  // namespace
}  // namespace canvoy::tools::device_catalogue_test
