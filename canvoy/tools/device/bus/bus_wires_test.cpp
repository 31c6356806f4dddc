// Switches and outputs of generic I/O, as seen by the device.
#include "canvoy/tools/device/bus/bus_wires.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::bus_wires_test {
namespace {

class BusWiresTest : public testing::Test {
 public:
  BusWiresTest() { wires.join(environment); }

  cia407::GenericIoHardware hardware() const {
    return environment.get<cia407::GenericIoHardware>();
  }
  template <class Act>
  static std::string said_of(Act act) {
    testing::internal::CaptureStdout();
    act();
    return testing::internal::GetCapturedStdout();
  }

  ReportedErrors errors;
  DeviceOutput output;
  BusWires wires{errors, output};
  Environment environment;
};

TEST_F(BusWiresTest, ASwitchIsThrownToAndFro) {
  wires.act({.what = "input", .numbers = {{"", 1}}});
  wires.act({.what = "input", .numbers = {{"", 32}}});
  EXPECT_EQ(hardware().digital_inputs(), 0x8000'0001);
  wires.act({.what = "input", .numbers = {{"", 1}}});
  wires.act({.what = "key", .numbers = {{"", 2}}});
  EXPECT_EQ(hardware().digital_inputs(), 0x8000'0000);
}

TEST_F(BusWiresTest, OutputsAreToldByTheirNumbersWhereTheyChange) {
  const auto set = [this](std::uint32_t outputs) {
    return said_of([&] { hardware().set_digital_outputs(outputs); });
  };
  EXPECT_EQ(set(0), "") << "all are off at first";
  EXPECT_EQ(set(0x8000'0005), "generic-io: outputs on: 1, 3, 32\n");
  EXPECT_EQ(set(0x8000'0005), "");
  EXPECT_EQ(set(0), "generic-io: outputs on: none\n");
}

TEST_F(BusWiresTest, EachAnalogueOutputIsToldWhereItChanges) {
  const auto set = [this](unsigned channel, std::int16_t value) {
    return said_of([&] { hardware().set_analogue_output(channel, value); });
  };
  EXPECT_EQ(set(8, 0), "");
  EXPECT_EQ(set(8, -32768), "generic-io: analogue output 8: -32768\n");
  EXPECT_EQ(set(8, -32768), "");
  EXPECT_EQ(set(1, -32768), "generic-io: analogue output 1: -32768\n");
}

TEST_F(BusWiresTest, AnOutputFailsWithTheErrorsOfTheBus) {
  EXPECT_FALSE(hardware().has_error(0x2320));
  errors.act({.what = "fail", .numbers = {{"", 0x2320}}});
  EXPECT_TRUE(hardware().has_error(0x2320));
  EXPECT_FALSE(hardware().has_error(0x2310));
}

}  // namespace
}  // namespace canvoy::tools::bus_wires_test
