// A car drive unit of lift 1 on its wire, in profile position mode. Its defaults: millimetres,
// 1.6 m/s, 1 m/s2, 1.2 m/s3, the brake takes 200 ms; ten increments are a millimetre.
#pragma once

#include <gtest/gtest.h>

#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"

namespace canvoy::cia417 {

/// Node 2, operational, in the state after its self-test.
class CarDriveTest : public testing::Test {
 protected:
  CarDriveTest() { bench.boot(device.node()); }

  std::uint16_t status() { return Values(device.node().dictionary())[statusword].raw(); }
  DriveState state() const { return device.unit().state(); }
  /// 180h with a target of 0.
  void control(std::uint16_t word) { control(word, target); }
  /// 180h, as a drive controller sends it.
  void control(std::uint16_t word, std::int32_t position) {
    target = position;
    Frame frame = Frame::data_frame(0x180, {});
    frame.length = 6;
    store(frame.data.data(), word);
    store(frame.data.data() + 2, position);
    bench.send(wire_text(frame));
  }
  void enable() {
    control(0x0006);
    control(0x0007);
    control(0x000F);
    bench.sent.clear();
  }
  /// Travels towards 12 m for `time`.
  void travel_for(Duration time) {
    enable();
    control(0x001F, 12'000);
    bench.run_for(time);
  }
  double position_mm() { return bench.sense().position / 10; }

  DriveBench bench;
  CarDriveDevice<> device{bench.port(), 2, bench.hardware()};
  std::int32_t target = 0;
};

}  // namespace canvoy::cia417
