// Hardware of devices as plain classes, of which the members are found by their names.
#include "canvoy/devices/kit/plain_hardware.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia401/io_device.hpp"
#include "canvoy/devices/cia417/door/car_door_hardware.hpp"
#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"
#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"
#include "canvoy/devices/cia417/panel/output_view.hpp"
#include "canvoy/devices/cia417/position/car_position_hardware.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/devices/cia852/operator_hardware.hpp"

namespace canvoy::plain_hardware_test {
namespace {

/// A class of no use: whether it has the members is seen when it is used.
struct Anything {};
template <class... Hardware>
constexpr bool can_be_plain = (PlainHardware<Anything, Hardware> && ...);
static_assert(can_be_plain<cia401::IoHardware, cia852::OperatorHardware, cia418::BatteryHardware,
                           cia417::LoadHardware, cia417::DoorHardware, cia417::CarDriveHardware,
                           cia417::CarPositionHardware, cia417::LightBarrierHardware,
                           cia417::OutputHardware>);
static_assert(!PlainHardware<cia401::IoHardware, cia401::IoHardware>);

struct Terminals {
  std::uint8_t digital_inputs(unsigned group) const { return group == 1 ? 0xA5 : 0; }
  void drive_digital(unsigned group, std::uint8_t outputs) {
    if (group == 1) driven = outputs;
  }
  unsigned driven = 0;
};

/// CiA 401: 6000h and 6200h, of eight inputs and outputs each.
TEST(PlainHardware, IsTheHardwareOfADevice) {
  Cable cable;
  Terminals terminals;
  cia401::IoDevice<cia401::IoOptions{.digital_inputs = 8, .digital_outputs = 8}> device(
      cable.port(0), 33, terminals);
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("621#40 00 60 01 00 00 00 00");
  EXPECT_EQ(cable.last(0x5A1), "5A1#4F 00 60 01 A5 00 00 00");
  cable.send("621#2F 00 62 01 3C 00 00 00");
  EXPECT_EQ(cable.last(0x5A1), "5A1#60 00 62 01 00 00 00 00");
  EXPECT_EQ(terminals.driven, 0x3Cu);
}

/// What it takes and returns is converted.
struct Cell {
  double rope_load(unsigned rope) { return 100.5 * rope; }
};
TEST(PlainHardware, ConvertsWhatItReturns) {
  Cell cell;
  const auto hardware = hardware_of<cia417::LoadHardware>(cell);
  EXPECT_EQ(hardware.rope_load(2), std::optional(201.0));
}

/// A door without a lock and a battery.
struct Door {
  cia417::DoorReadings sense(Time) { return {.is_open = true}; }
  void drive(const cia417::DoorDrive& wanted, Time) { motion = wanted.motion; }
  cia417::DoorDrive::Motion motion = cia417::DoorDrive::Motion::none;
};
TEST(PlainHardware, LacksWhatTheClassLacks) {
  Door door;
  const auto hardware = hardware_of<cia417::DoorHardware>(door);
  EXPECT_TRUE(hardware.sense(Time{}).is_open);
  hardware.drive({.motion = cia417::DoorDrive::Motion::close}, Time{});
  EXPECT_EQ(door.motion, cia417::DoorDrive::Motion::close);
  EXPECT_FALSE(hardware.lock);
  EXPECT_FALSE(hardware.use_battery);
}

}  // namespace
}  // namespace canvoy::plain_hardware_test
