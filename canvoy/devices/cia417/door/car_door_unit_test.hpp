// A car door unit on a cable, with the test at the other end.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"

namespace canvoy::cia417 {

/// Door 1 of lift 1, node-ID 6, operational.
class CarDoorTest : public testing::Test {
 protected:
  CarDoorTest() {
    cable.connect(0, door.node());
    cable.start_all();
    cable.send("000#01 06");
  }

  /// Writes it by PDO, with all other fields unchanged.
  void command(unsigned number) {
    char text[40];
    std::snprintf(text, sizeof text, "200#FF %XF FF FF FF FF FF FF", number);
    cable.send(text);
  }
  void order_by_sdo(unsigned value) {
    char text[40];
    std::snprintf(text, sizeof text, "606#2B 00 63 01 %02X %02X 00 00", value & 0xFF, value >> 8);
    cable.send(text);
  }
  /// Writes a byte by SDO; the answer is the last 586.
  void write(unsigned index, unsigned sub, unsigned value) {
    char text[40];
    std::snprintf(text, sizeof text, "606#2F %02X %02X %02X %02X 00 00 00", index & 0xFF,
                  index >> 8, sub, value);
    cable.send(text);
  }
  void open() {
    command(0x4);
    cable.run_for(3s);
    ASSERT_EQ(state(), DoorState::opened_with_torque);
    cable.clear();
  }
  /// Applies a change that the test has made to the bench.
  void changed() {
    unit().hardware_changed();
    cable.run_for(0s);
  }
  CarDoorUnit& unit() { return door.unit(); }
  DoorState state() const { return door.unit().state(); }
  unsigned word() { return static_cast<unsigned>(door.node().dictionary().number(0x6301, 1)); }

  Cable cable;
  DoorBench bench;
  CarDoorDevice<> door{cable.port(0), 6, {bench.hardware()}};
};

}  // namespace canvoy::cia417
