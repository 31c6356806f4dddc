// A car drive controller at the wire: the test plays drive (node 2) and position unit (node 4).
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "canvoy/devices/cia417/drive/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/drive/car_drive_test.hpp"

namespace canvoy::cia417 {

class DriveControllerAtTheWire : public testing::Test {
 protected:
  DriveControllerAtTheWire() { begin_anew(); }
  void begin_anew() {
    bench.boot(device.node());
    hear("18C#00 00 00 00");
    hear("185#50 02 00 00 00 00");
  }
  CarDriveController& controller() { return device.unit().controller(); }
  void hear(std::string_view frame) {
    bench.sent.clear();
    bench.send(frame);
  }
  /// Changes to "switched on", in the mode of trips.
  void switch_on_for_a_trip() {
    EXPECT_TRUE(bench.has_sent("180#06 00 00 00 00 00"));
    hear("181#31 02 00 00 00 00");
    EXPECT_TRUE(bench.has_sent("602#2F 03 64 00 01 00 00 00")) << "profile position";
    hear("582#60 03 64 00 00 00 00 00");
    EXPECT_TRUE(bench.has_sent("180#07 00 00 00 00 00"));
    hear("181#33 02 00 00 00 00");
  }
  /// Starts a trip to 12 m, with operation enabled.
  void begin_trip() {
    order([&] { controller().travel_to(12'000'000); });
    switch_on_for_a_trip();
    hear("181#37 02 00 00 00 00");
    bench.run_for(5ms);
    hear("181#37 12 00 00 00 00");
  }
  void order(const std::function<void()>& command) {
    bench.sent.clear();
    device.node().advance(bench.now);
    command();
    bench.settle();
  }

  DriveBench bench;
  CarDriveControllerDevice<> device{bench.port(), 1};
};

}  // namespace canvoy::cia417
