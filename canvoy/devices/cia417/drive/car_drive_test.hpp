// The hardware of a simple simulated car drive, for tests: a car that follows its profile exactly,
// unless the test controls it.
//
//     DriveBench bench;
//     CarDriveDevice<> drive(bench.port(), 2, bench.hardware());
//     bench.boot(drive.node());
//     bench.send("180#0F 00 00 00 00 00");
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"

namespace canvoy::cia417 {

class DriveBench {
 public:
  Port port() { return {this, &DriveBench::take, nullptr}; }
  CarDriveHardware hardware() {
    return {.sense = callback<&DriveBench::sense>(*this),
            .power = callback<&DriveBench::set_power>(*this),
            .release_brake = callback<&DriveBench::set_brake>(*this),
            .follow = callback<&DriveBench::set_profile>(*this),
            .arrest = callback<&DriveBench::arrest>(*this),
            .brake_holds = callback<&DriveBench::test_brake>(*this)};
  }

  /// The node that has the clock.
  void connect(Node& node) { node_ = &node; }
  /// Starts the node and makes it operational; after a tenth of a second the car counts as
  /// standing.
  void boot(Node& node) {
    node_ = &node;
    node.start(now);
    send("000#01 00");
    run_for(100ms);
    sent.clear();
  }
  void send(std::string_view frame) {
    node_->receive(wire_frame(frame), now);
    settle();
  }
  void settle() {
    for (int i = 0; node_->deadline() <= now; ++i) {
      ASSERT_LT(i, 10'000) << "the node wants to be called again and again";
      node_->advance(now);
    }
  }
  void run_until(Time until) {
    while (node_->deadline() <= until) {
      now = std::max(now, node_->deadline());
      settle();
      speed_max = std::max(speed_max, std::abs(sense().velocity));
    }
    now = until;
  }
  void run_for(Duration duration) { run_until(now + duration); }

  /// True if a frame was sent, of those since the last boot or clear.
  bool has_sent(std::string_view frame) const {
    return std::ranges::any_of(sent, [&](const Frame& f) { return wire_text(f) == frame; });
  }

  /// The answer of the SDO server of node 2: bytes 4 to 7, or the abort code.
  std::uint32_t ask(std::string_view request) {
    sent.clear();
    send("602#" + std::string(request));
    for (const Frame& frame : sent) {
      if (frame.id == 0x582) return load<std::uint32_t>(frame.data.data() + 4);
    }
    return 0xDEAD'BEEF;
  }

  DriveReadings sense() {
    DriveReadings shown = readings;
    if (power && brake_released && !detached) {
      const MotionState at = profile.at(std::chrono::duration<double>(now - start).count());
      shown.position = at.position;
      shown.velocity = shown.sensor_velocity = at.velocity;
      readings.position = at.position;
    }
    if (home_switch && shown.position <= *home_switch) shown.home_position = home_switch;
    return shown;
  }

  Time now{};
  std::vector<Frame> sent;
  DriveReadings readings;
  bool detached = false;  ///< from here on the test sets `readings`
  std::optional<double> home_switch;
  bool power = false;
  bool brake_released = false;
  int arrests = 0;
  int brake_tests = 0;
  bool brake_holds = true;
  double speed_max = 0;
  MotionProfile profile;
  Time start{};

 private:
  static bool take(void* context, const Frame& frame) {
    static_cast<DriveBench*>(context)->sent.push_back(frame);
    return true;
  }
  void set_power(bool on) { power = on; }
  void set_brake(bool released) { brake_released = released; }
  void set_profile(const MotionProfile& next, Duration delay) {
    profile = next;
    start = node_->now() + delay;
  }
  void arrest() { ++arrests; }
  bool test_brake() {
    EXPECT_TRUE(power && !brake_released) << "the motor pushes against the closed brake";
    ++brake_tests;
    return brake_holds;
  }

  Node* node_ = nullptr;
};

}  // namespace canvoy::cia417
