// Faults of the devices of a bus, as each of them reads them.
#include "canvoy/tools/device/bus/reported_errors.hpp"

#include <gtest/gtest.h>

#include <array>

namespace canvoy::tools::bus_errors_test {
namespace {

using cia407::CodeOnlyHardware, cia407::DeviceCode;

constexpr std::uint16_t no_connection = cia407::bus_error::no_radio_connection;

class BusErrorsTest : public testing::Test {
 public:
  BusErrorsTest() { errors.join(environment); }

  template <DeviceCode code>
  bool has(std::uint16_t error) const {
    return environment.get<CodeOnlyHardware<code>>().has_error(error);
  }

  ReportedErrors errors;
  Environment environment;
};

TEST_F(BusErrorsTest, AnErrorLastsUntilItIsMended) {
  EXPECT_FALSE(has<DeviceCode::power_supply>(0x3110));
  errors.act({.what = "fail", .numbers = {{"", 0x3110}}});
  errors.act({.what = "fail", .numbers = {{"", 0x2320}}});
  EXPECT_TRUE(has<DeviceCode::power_supply>(0x3110));
  EXPECT_FALSE(has<DeviceCode::power_supply>(0x3120));
  errors.act({.what = "mend", .numbers = {{"", 0x3110}}});
  EXPECT_FALSE(has<DeviceCode::power_supply>(0x3110));
  EXPECT_TRUE(has<DeviceCode::power_supply>(0x2320)) << "the other one stays";
}

TEST_F(BusErrorsTest, AllRadiosLoseTheirConnectionTogether) {
  const auto lost = [this] {
    return std::array{has<DeviceCode::data_radio>(no_connection),
                      has<DeviceCode::voice_radio>(no_connection),
                      has<DeviceCode::short_range_communication>(no_connection)};
  };
  constexpr std::array none = {false, false, false};
  constexpr std::array all = {true, true, true};
  EXPECT_EQ(lost(), none);
  errors.act({.what = "disconnect"});
  EXPECT_EQ(lost(), all);
  EXPECT_FALSE(has<DeviceCode::power_supply>(no_connection)) << "it is no radio";
  errors.act({.what = "connect"});
  EXPECT_EQ(lost(), none);
}

}  // namespace
}  // namespace canvoy::tools::bus_errors_test
