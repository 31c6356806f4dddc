// A whole lift on a cable: its controller, a drive and a door. The test plays the position unit,
// the load unit and the panels.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/door/car_door_test.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"

namespace canvoy::cia417 {

inline constexpr std::array<std::int32_t, 8> heights{
    0, 4'000'000, 7'000'000, 10'000'000, 13'000'000, 16'000'000, 19'000'000, 22'000'000};
inline LiftControllerDeviceSettings lift_settings() {
  return {.calls = {.served = {FloorSet::between(1, 8)}}, .lift = {.floors = heights}};
}

class WholeLift : public testing::Test {
 protected:
  explicit WholeLift(const LiftControllerDeviceSettings& settings = lift_settings())
      : controller(cable.port(0), 1, settings) {
    cable.connect(0, controller.node());
    cable.connect(1, drive.node());
    bench.connect(drive.node());
    cable.connect(2, door.node());
    cable.start_all();
    tell();
    cable.send("188#01");
    run_for(5s);
  }
  /// Sends the messages of the units that the test plays: the position is that of the drive's car.
  void tell() {
    bench.now = cable.now;
    if (has_position) {
      Frame frame = Frame::data_frame(0x18C, {});
      frame.length = 4;
      store(frame.data.data(), static_cast<std::int32_t>(std::lround(bench.sense().position)));
      cable.send(wire_text(frame));
      cable.send("704#05");
    }
    if (has_load) cable.send("70D#05");
  }
  void step() {
    cable.run_for(20ms);
    tell();
  }
  void run_for(Duration time) {
    for (const Time end = cable.now + time; cable.now < end;) step();
  }
  bool run_until(const std::function<bool()>& done, Duration most = 60s) {
    for (const Time end = cable.now + most; cable.now < end && !done();) step();
    return done();
  }
  bool is_open_at(std::uint8_t floor) {
    return controller.lift().phase() == LiftPhase::open && door_bench.position_mm > 899 &&
           std::abs(bench.sense().position * 100 - heights[floor - 1U]) <= 10'000;
  }
  /// A passenger presses the button of this floor.
  void press_in_car(unsigned floor) {
    char frame[32];
    std::snprintf(frame, sizeof frame, "490#05 %02X 01 00 11 01", floor);
    cable.send(frame);
  }
  bool arrives_at(std::uint8_t floor, Duration most = 60s) {
    return run_until([this, floor] { return is_open_at(floor); }, most);
  }
  /// True if its doors close and it comes to rest.
  bool comes_to_rest() {
    return run_until([this] { return controller.lift().phase() == LiftPhase::idle; });
  }
  std::size_t count(const std::string& frame) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        cable.heard, [&](const auto& heard) { return wire_text(heard.frame) == frame; }));
  }

  Cable cable;
  DriveBench bench;
  DoorBench door_bench;
  bool has_position = true;
  bool has_load = true;
  LiftControllerDevice<> controller;
  CarDriveDevice<> drive{cable.port(1), 2, bench.hardware()};
  CarDoorDevice<> door{cable.port(2), 6, {door_bench.hardware()}};
};

}  // namespace canvoy::cia417
