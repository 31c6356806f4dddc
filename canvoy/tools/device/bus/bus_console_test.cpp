// Keys, gear lever and display of a driver's console, as seen by its devices.
#include "canvoy/tools/device/bus/bus_console.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::bus_console_test {
namespace {

class BusConsoleTest : public testing::Test {
 public:
  BusConsoleTest() { console.join(environment); }

  Time clock() { return now; }
  void press(unsigned key) { console.act({.what = "key", .numbers = {{"", key}}}); }
  /// State of the keyboard at this time.
  std::uint32_t keys_at(Time time) {
    now = time;
    console.step(now);
    return environment.get<cia407::KeyboardHardware>().keys();
  }
  std::string said_of(const cia407::DriverView& view) {
    testing::internal::CaptureStdout();
    environment.get<cia407::DriverIndicatorHardware>().show(view);
    return testing::internal::GetCapturedStdout();
  }

  Time now = Time(5s);
  DeviceOutput output;
  BusConsole console{callback<&BusConsoleTest::clock>(*this), output};
  Environment environment;
};

TEST_F(BusConsoleTest, AKeyIsHeldForAShortTime) {
  EXPECT_EQ(keys_at(Time(5s)), 0);
  press(5);
  EXPECT_EQ(keys_at(Time(5299ms)), 0x10);
  EXPECT_EQ(keys_at(Time(5300ms)), 0);
}

TEST_F(BusConsoleTest, EachKeyHasItsOwnTime) {
  press(1);
  now = Time(5200ms);
  press(32);
  EXPECT_EQ(keys_at(Time(5200ms)), 0x8000'0001);
  EXPECT_EQ(keys_at(Time(5300ms)), 0x8000'0000);
  EXPECT_EQ(keys_at(Time(5500ms)), 0);
}

TEST_F(BusConsoleTest, AKeyThatIsPressedAgainIsHeldAnew) {
  press(2);
  now = Time(5200ms);
  press(2);
  EXPECT_EQ(keys_at(Time(5499ms)), 2);
  EXPECT_EQ(keys_at(Time(5500ms)), 0);
}

TEST_F(BusConsoleTest, TheGearLeverStaysWhereItIs) {
  const cia407::KeyboardHardware keyboard = environment.get<cia407::KeyboardHardware>();
  EXPECT_FALSE(keyboard.is_reverse_engaged());
  console.act({.what = "reverse"});
  console.act({.what = "stop"});
  EXPECT_TRUE(keyboard.is_reverse_engaged());
  EXPECT_TRUE(console.is_reverse());
  console.act({.what = "forward"});
  EXPECT_FALSE(keyboard.is_reverse_engaged());
}

TEST_F(BusConsoleTest, TheDisplayIsToldWithWhatIsKnown) {
  EXPECT_EQ(said_of({}), "driver-display: --:--, doors not open\n");
  EXPECT_EQ(said_of({.time = cia407::CivilTime{.hour = 8, .minute = 5},
                     .has_open_door = true,
                     .right_released = true,
                     .ambient_celsius = 11.5,
                     .is_braking = true,
                     .last_error = 0x1000FF02}),
            "driver-display: 08:05, doors open, released right, 11.5 C outside, braking, error "
            "1000FF02h\n");
}

TEST_F(BusConsoleTest, WhatIsReadTheSameIsNotToldAgain) {
  said_of({.ambient_celsius = 11.51});
  EXPECT_EQ(said_of({.ambient_celsius = 11.52}), "");
  EXPECT_EQ(said_of({.ambient_celsius = 11.6}),
            "driver-display: --:--, doors not open, 11.6 C outside\n");
}

}  // namespace
}  // namespace canvoy::tools::bus_console_test
