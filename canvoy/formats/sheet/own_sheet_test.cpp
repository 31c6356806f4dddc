#include "canvoy/formats/sheet/own_sheet.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::formats {
namespace {

constexpr ObjectInfo speed{
    .index = 0x2000,
    .name = "speed",
    .entry = {.type = DataType::unsigned16, .access = Access::rw, .initial = 100}};
constexpr auto pump = describe(cia301::device_type(0), cia301::error_register_object,
                               cia301::identity({.vendor_id = 0x123, .product_code = 7}),
                               cia301::heartbeat_producer(1000), speed);

/// Content of a section, one line for each key.
std::string section(std::string text, const std::string& name) {
  std::erase(text, '\r');
  text += '\n';
  const std::size_t begin = text.find("[" + name + "]\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find("\n\n", begin) - begin);
}

bool has_line(const std::string& text, const std::string& line) {
  return text.find("\n" + line + "\n") != std::string::npos;
}

TEST(OwnSheet, NamesObjectsOfTheManufacturer) {
  const std::string text = own_sheet(pump, {.product_name = "Pump"});
  const std::string own = section(text, "2000") + "\n";
  EXPECT_TRUE(has_line(own, "ParameterName=speed")) << text;
  EXPECT_TRUE(has_line(own, "DataType=0x0006")) << own;  // CiA 301, 7.4.7.1: UNSIGNED16
  EXPECT_TRUE(has_line(own, "AccessType=rw")) << own;
  EXPECT_TRUE(has_line(section(text, "ManufacturerObjects") + "\n", "1=0x2000")) << text;
}

TEST(OwnSheet, TellsTheIdentityOfItsDescription) {
  const std::string info = section(own_sheet(pump, {.product_name = "Pump"}), "DeviceInfo") + "\n";
  EXPECT_TRUE(has_line(info, "ProductName=Pump")) << info;
  EXPECT_TRUE(has_line(info, "VendorNumber=0x00000123")) << info;
  EXPECT_TRUE(has_line(info, "ProductNumber=0x00000007")) << info;
}

TEST(OwnSheet, IsOfTheProfileThatItsDeviceTypeNames) {
  constexpr auto charger = describe(cia419::charger({}), speed);
  const std::string text = own_sheet(charger, {});
  EXPECT_NE(section(text, "FileInfo").find("Description=CiA 419"), std::string::npos) << text;
  EXPECT_NE(section(text, "6000").find("ParameterName=battery_status"), std::string::npos) << text;
  EXPECT_NE(section(text, "2000").find("ParameterName=speed"), std::string::npos) << text;
}

TEST(OwnSheet, OfANodeIsADcf) {
  const std::string text = own_sheet(pump, {.product_name = "Pump", .node_id = 9});
  EXPECT_NE(section(text, "DeviceComissioning").find("NodeID=9"), std::string::npos) << text;
}

TEST(OwnSheet, AFileThatCannotBeWrittenIsToldByTheExitStatus) {
  EXPECT_EQ(write_own_sheet(pump, {}, "/nowhere/at/all/pump.eds"), 1);
}

}  // namespace
}  // namespace canvoy::formats
