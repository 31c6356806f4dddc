// The configurations of four doors in one device, 6304h to 6307h: each entry has the effect of
// 4.7.3 (and of 4.7.4 to 4.7.6, which are equal) on its own door, and none on the others.
#include <gtest/gtest.h>

#include <array>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"

namespace canvoy::cia417::car_door_configuration_test {
namespace {

using enum DoorState;

class DoorConfiguration : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr LiftDeviceOptions all_doors = {.doors = 0b1111, .parts = 128};

  DoorConfiguration() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 06");
  }

  /// By SDO; whether it was taken.
  bool set(unsigned door, unsigned sub, unsigned value) {
    char text[40];
    std::snprintf(text, sizeof text, "606#2F %02X 63 %02X %02X 00 00 00", 0x03 + door, sub, value);
    cable.send(text);
    return cable.last(0x586).starts_with("586#60");
  }
  /// Of the door that is tested.
  void set(unsigned sub, unsigned value) { EXPECT_TRUE(set(GetParam(), sub, value)); }
  void set_all(unsigned sub, unsigned value) {
    for (unsigned door = 1; door <= 4; ++door) EXPECT_TRUE(set(door, sub, value));
  }
  void open() { cable.send("200#FF 4F FF 4F FF 4F FF 4F"); }
  /// A second on the way.
  void open_for_a_second() {
    open();
    cable.run_for(1s);
  }
  void close_for_a_second() {
    open();
    cable.run_for(3s);
    cable.send("200#FF 1F FF 1F FF 1F FF 1F");
    cable.run_for(1s);
  }
  /// At all doors.
  void sense(Detection DoorBench::*detector, Detection seen) {
    for (DoorBench& bench : benches) bench.*detector = seen;
    for (unsigned door = 0; door < 4; ++door) device.unit().door(door).hardware_changed();
    cable.run_for(0s);
  }
  void expect(DoorState here, DoorState elsewhere) {
    for (unsigned door = 1; door <= 4; ++door) {
      EXPECT_EQ(device.unit().door(door - 1).state(), door == GetParam() ? here : elsewhere)
          << "door " << door;
    }
  }
  const DoorDrive& driven(unsigned door) const { return benches[door - 1].driven; }

  Cable cable;
  std::array<DoorBench, 4> benches;
  CarDoorDevice<all_doors> device{
      cable.port(0),
      6,
      {benches[0].hardware(), benches[1].hardware(), benches[2].hardware(), benches[3].hardware()},
      {.velocity_profiles = 3, .width_profiles = 3}};
};

TEST_P(DoorConfiguration, HasTheProfilesOfVelocityAndWidth) {
  set(0x01, 2);
  set(0x02, 1);
  open();
  for (unsigned door = 1; door <= 4; ++door) {
    EXPECT_EQ(driven(door).velocity_profile, door == GetParam() ? 2 : 0);
    EXPECT_EQ(driven(door).width_profile, door == GetParam() ? 1 : 0);
  }
}

TEST_P(DoorConfiguration, HasTheTypeOfTheDoor) {
  for (unsigned type = 0; type <= 3; ++type) {
    set(0x03, type);
    char text[40];
    std::snprintf(text, sizeof text, "606#40 %02X 63 03 00 00 00 00", 0x03 + GetParam());
    cable.send(text);
    EXPECT_EQ(cable.last(0x586).substr(16, 2), "0" + std::to_string(type));
  }
  EXPECT_FALSE(set(GetParam(), 0x03, 4)) << "reserved";
}

TEST_P(DoorConfiguration, LightBarrierEventReOpens) {
  set(0x04, 1);
  close_for_a_second();
  sense(&DoorBench::light_barrier, Detection::yes);
  expect(re_opening, closing);
}

TEST_P(DoorConfiguration, LightBarrierEventStops) {
  set(0x04, 2);
  close_for_a_second();
  sense(&DoorBench::light_barrier, Detection::yes);
  expect(stopped, closing);
}

TEST_P(DoorConfiguration, ForceLimitReOpens) {
  set(0x05, 1);
  close_for_a_second();
  sense(&DoorBench::force_limit, Detection::yes);
  expect(re_opening, closing);
}

TEST_P(DoorConfiguration, ForceLimitStops) {
  set(0x05, 2);
  close_for_a_second();
  sense(&DoorBench::force_limit, Detection::yes);
  expect(stopped, closing);
}

TEST_P(DoorConfiguration, FingerProtectorReCloses) {
  set(0x06, 1);
  open_for_a_second();
  sense(&DoorBench::finger, Detection::yes);
  expect(closing, opening);
}

TEST_P(DoorConfiguration, FingerProtectorStops) {
  set(0x06, 2);
  open_for_a_second();
  sense(&DoorBench::finger, Detection::yes);
  expect(stopped, opening);
}

TEST_P(DoorConfiguration, MotionReOpensAsLongAsThereIsSome) {
  set(0x07, 1);
  close_for_a_second();
  sense(&DoorBench::motion, Detection::yes);
  expect(re_opening, closing);
  sense(&DoorBench::motion, Detection::no);
  expect(closing, closing);
}

TEST_P(DoorConfiguration, MotionStops) {
  set(0x07, 2);
  close_for_a_second();
  sense(&DoorBench::motion, Detection::yes);
  expect(stopped, closing);
}

TEST_P(DoorConfiguration, LightBarrierReCloseIsInSeconds) {
  set_all(0x04, 1);
  set(0x08, 5);
  close_for_a_second();
  sense(&DoorBench::light_barrier, Detection::yes);
  sense(&DoorBench::light_barrier, Detection::no);
  cable.run_for(1s);  // open again
  cable.run_for(4999ms);
  expect(opened_with_torque, opened_with_torque);
  cable.run_for(1ms);
  expect(closing, opened_with_torque);
}

TEST_P(DoorConfiguration, ClosingForceLimitReCloseIsInSeconds) {
  set_all(0x05, 1);
  set(0x09, 255);
  close_for_a_second();
  sense(&DoorBench::force_limit, Detection::yes);
  sense(&DoorBench::force_limit, Detection::no);
  cable.run_for(1s);
  cable.run_for(255s - 1ms);
  expect(opened_with_torque, opened_with_torque);
  cable.run_for(1ms);
  expect(closing, opened_with_torque);
}

TEST_P(DoorConfiguration, LightBarrierBrokenIsInTwoSeconds) {
  set_all(0x04, 1);
  set(0x0A, 255);
  close_for_a_second();
  sense(&DoorBench::light_barrier, Detection::error);
  cable.run_for(1s);
  cable.run_for(510s - 1ms);
  expect(opened_with_torque, opened_with_torque);
  cable.run_for(1ms);
  expect(closing, opened_with_torque);
}

TEST_P(DoorConfiguration, LostHeartbeatStopsWithOrWithoutTorque) {
  set(0x0B, 1);
  open();
  cable.send("701#05");
  cable.run_for(1s);
  expect(stopped, stopped);
  for (unsigned door = 1; door <= 4; ++door) {
    EXPECT_EQ(driven(door).has_torque, door == GetParam());
  }
}

TEST_P(DoorConfiguration, LostHeartbeatClosesWithReducedSpeed) {
  set(0x0B, 2);
  open();
  cable.send("701#05");
  cable.run_for(1s);
  expect(closing, stopped);
  EXPECT_TRUE(driven(GetParam()).is_reduced);
}

INSTANTIATE_TEST_SUITE_P(Door, DoorConfiguration, testing::Values(1, 2, 3, 4));

}  // namespace
}  // namespace canvoy::cia417::car_door_configuration_test
