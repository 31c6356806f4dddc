// A lift controller with a simple simulated car: 1 m/s without acceleration, doors that take 2 s,
// floors 3 m apart, in steps of 10 ms.
//
//     LiftBench bench;
//     bench.start();
//     bench.press("02 01 01 03 10 01");
//     bench.run_until([&] { return bench.lift.floor() == 3; });
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/testing/lift_bench.hpp"

namespace canvoy::cia417 {

class LiftBench {
 public:
  static constexpr auto floors = [] {
    std::array<std::int32_t, 10> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<std::int32_t>(i) * 3 * bench_metre;
    }
    return made;
  }();

  explicit LiftBench(LiftControllerSettings settings = {}, unsigned number = 1,
                     const FloorSet& served = FloorSet::between(1, 10),
                     DoorMask doors_of_car = 0b11)
      : device(cable.port(0), 1,
               {.lift = number, .served = {served, served & FloorSet::between(5, 5)}}),
        lift(device.node(), device.calls(),
             {car.interface(), doors.interface(), callback<&LiftBench::load>(*this)},
             complete(settings, doors_of_car)) {
    cable.connect(0, device.node());
  }
  void start() {
    cable.start_all();
    cable.send("000#01 01");
    run_for(100ms);
    cable.clear();
  }
  /// A record of a panel, from the car or a landing.
  void press(const std::string& record) { cable.send("490#" + record); }
  /// Turns a key of the car, or holds a button.
  void turn(SpecialFunction function, bool on = true) {
    char record[32];
    std::snprintf(record, sizeof record, "0E %02X 01 00 10 %02X", static_cast<unsigned>(function),
                  on ? 0x81U : 0x80U);
    press(record);
    step();
  }

  void step() {
    car.step(doors.are_closed());
    doors.step();
    cable.run_for(10ms);
    device.node().advance(cable.now);
    if (car.motion != told_motion || doors.status() != told_doors || weighed != told_load) {
      told_motion = car.motion;
      told_doors = doors.status();
      told_load = weighed;
      lift.update();
    }
    cable.run_for(0ms);
  }
  void run_for(Duration duration) {
    for (const Time end = cable.now + duration; cable.now < end;) step();
  }
  /// True if the condition came true in time.
  bool run_until(const std::function<bool()>& done, Duration most = 120s) {
    for (const Time end = cable.now + most; cable.now < end;) {
      if (done()) return true;
      step();
    }
    return done();
  }
  bool run_to(std::uint8_t floor, LiftPhase phase) {
    return run_until([&] { return lift.phase() == phase && at(floor); });
  }
  bool at(std::uint8_t floor) const {
    return car.motion.standing && car.motion.position_micrometre == floors[floor - 1U];
  }
  std::size_t told(const std::string& record) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        cable.heard, [&](const auto& heard) { return wire_text(heard.frame) == record; }));
  }

  BenchCar car;
  BenchDoors doors;
  LiftLoad weighed;
  Cable cable;
  CallControllerDevice<> device;
  LiftController lift;

 private:
  static LiftControllerSettings complete(LiftControllerSettings settings, DoorMask doors_of_car) {
    settings.floors = floors;
    settings.doors = doors_of_car;
    return settings;
  }
  LiftLoad load() { return weighed; }

  MotionStatus told_motion;
  DoorsStatus told_doors;
  LiftLoad told_load;
};

/// A lift that serves. In no test does it move with an unlocked door.
class LiftBenchTest : public testing::Test {
 protected:
  LiftBenchTest() { bench.start(); }
  ~LiftBenchTest() override { EXPECT_FALSE(bench.car.left_unlocked); }

  LiftBench bench;
  LiftController& lift = bench.lift;
};

}  // namespace canvoy::cia417
