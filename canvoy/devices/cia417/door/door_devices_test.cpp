// Common rules for the devices of doors and loads: the lift to which they belong, and an answer to
// every request.
#include <gtest/gtest.h>

#include <bit>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"

namespace canvoy::cia417::door_devices_test {
namespace {

constexpr LiftDeviceOptions door_of_lift_2 = {.lift = 2, .doors = 0b0001};
constexpr LiftDeviceOptions lift_2 = {.lift = 2};

Detection nobody(void*, unsigned) {
  return Detection::no;
}
std::optional<double> nothing(void*, unsigned) {
  return 0;
}

class DoorDevices : public testing::Test {
 protected:
  DoorDevices() {
    cable.connect(0, door.node());
    cable.connect(1, controller.node());
    cable.connect(2, barrier.node());
    cable.connect(3, load.node());
    cable.start_all();
  }
  std::string answer(unsigned node, std::string_view data) {
    char id[8];
    std::snprintf(id, sizeof id, "%03X#", 0x600 + node);
    cable.send(std::string(id) + std::string(data));
    return cable.last(0x580 + node).substr(4);
  }

  Cable cable;
  DoorBench bench;
  CarDoorDevice<door_of_lift_2> door{cable.port(0), 6, {bench.hardware()}};
  CarDoorControllerDevice<lift_2> controller{cable.port(1), 1, {}};
  LightBarrierDevice<door_of_lift_2> barrier{cable.port(2), 9, {.sense = {&nobody, nullptr}}};
  LoadMeasuringDevice<lift_2> load{cable.port(3), 13, {.rope_load = {&nothing, nullptr}}};
};

TEST_F(DoorDevices, EachBelongsToItsOneLift) {
  for (const unsigned node : {6U, 1U, 9U, 13U}) {
    EXPECT_EQ(answer(node, "40 01 60 00 00 00 00 00"), "4F 01 60 00 02 00 00 00");
    for (unsigned lifts = 0; lifts <= 0xFF; ++lifts) {
      char request[40];
      std::snprintf(request, sizeof request, "2F 01 60 00 %02X 00 00 00", lifts);
      EXPECT_EQ(answer(node, request), lifts == 0                   ? "80 01 60 00 32 00 09 06"
                                       : std::has_single_bit(lifts) ? "60 01 60 00 00 00 00 00"
                                                                    : "80 01 60 00 30 00 09 06")
          << node;
    }
  }
}

TEST_F(DoorDevices, EachSaysWhatItIs) {
  EXPECT_EQ(answer(6, "40 00 10 00 00 00 00 00"), "43 00 10 00 A1 01 00 05");
  EXPECT_EQ(answer(1, "40 00 10 00 00 00 00 00"), "43 00 10 00 A1 01 00 04");
  EXPECT_EQ(answer(9, "40 00 10 00 00 00 00 00"), "43 00 10 00 A1 01 00 07");
  EXPECT_EQ(answer(13, "40 00 10 00 00 00 00 00"), "43 00 10 00 A1 01 00 0A");
}

TEST_F(DoorDevices, WhatADoorTellsIsReadOnlyAtItsSource) {
  EXPECT_EQ(answer(6, "2B 01 6B 01 00 00 00 00"), "80 01 6B 01 02 00 01 06");
  EXPECT_EQ(answer(6, "2B 02 6B 01 00 00 00 00"), "80 02 6B 01 02 00 01 06");
  EXPECT_EQ(answer(9, "2F 10 6B 01 00 00 00 00"), "80 10 6B 01 02 00 01 06");
  EXPECT_EQ(answer(13, "2F 82 6C 01 00 00 00 00"), "80 82 6C 01 02 00 01 06");
  EXPECT_EQ(answer(1, "2B 00 6B 01 00 00 00 00"), "80 00 6B 01 02 00 01 06");
  EXPECT_EQ(answer(1, "2B 01 6B 01 FF FF 00 00"), "60 01 6B 01 00 00 00 00") << "consumed: rw";
}

}  // namespace
}  // namespace canvoy::cia417::door_devices_test
