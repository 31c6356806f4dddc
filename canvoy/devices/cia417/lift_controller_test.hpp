// A lift controller with a car of plain numbers: 1 m/s at once, doors that take 2 s, floors 3 m
// apart, in steps of 10 ms.
//
//     LiftBench bench;
//     bench.start();
//     bench.press("02 01 01 03 10 01");
//     bench.run_until([&] { return bench.lift.floor() == 3; });
#pragma once

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/call_controller_device.hpp"
#include "canvoy/devices/cia417/lift_controller.hpp"

namespace canvoy::cia417 {

inline constexpr std::int32_t bench_metre = 1'000'000;

struct BenchCar {
  static constexpr std::int32_t step_micrometre = 10'000;  // in 10 ms
  static constexpr std::int32_t braking_micrometre = bench_metre / 2;

  MotionStatus motion{.available = true};
  std::int32_t target = 0;
  std::int32_t run_speed = 0;
  bool is_driving = false;
  bool is_stuck = false;
  unsigned fast_stops = 0;
  bool left_unlocked = false;  ///< it moved with a door that was not locked

  void travel_to(std::int32_t position) {
    target = position;
    is_driving = position != motion.position_micrometre;
    motion.arrived = !is_driving;
    motion.standing = !is_driving;
  }
  void run(std::int32_t speed) {
    run_speed = speed;
    motion.standing = motion.arrived = false;
  }
  void stop() {
    run_speed = 0;
    is_driving = false;
    motion.standing = true;
    motion.velocity_micrometre_per_second = 0;
    motion.stopping_position_micrometre = motion.position_micrometre;
  }
  void fast_stop() {
    ++fast_stops;
    stop();
  }
  MotionStatus status() { return motion; }

  void step(bool locked) {
    if (run_speed != 0) {
      motion.position_micrometre += run_speed / 100;
      motion.velocity_micrometre_per_second = run_speed;
      motion.stopping_position_micrometre = motion.position_micrometre;
    }
    if (is_driving && !is_stuck) {
      const std::int32_t left = target - motion.position_micrometre;
      const std::int32_t sign = left > 0 ? 1 : -1;
      motion.position_micrometre += sign * std::min(step_micrometre, std::abs(left));
      motion.velocity_micrometre_per_second = sign * bench_metre;
      const std::int32_t braking = std::min(braking_micrometre, std::abs(left) - step_micrometre);
      motion.stopping_position_micrometre =
          motion.position_micrometre + sign * std::max(braking, 0);
      if (motion.position_micrometre == target) {
        stop();
        motion.arrived = true;
      }
    }
    left_unlocked = left_unlocked || (!motion.standing && !locked);
  }
  LiftMotion interface() {
    return {.travel_to = Callback<void(std::int32_t)>::to<&BenchCar::travel_to>(*this),
            .run = Callback<void(std::int32_t)>::to<&BenchCar::run>(*this),
            .stop = Callback<void()>::to<&BenchCar::stop>(*this),
            .fast_stop = Callback<void()>::to<&BenchCar::fast_stop>(*this),
            .status = Callback<MotionStatus()>::to<&BenchCar::status>(*this)};
  }
};

/// Two doors.
struct BenchDoors {
  static constexpr int travel_steps = 200;  // 2 s

  std::array<int, 2> open_steps{};
  std::array<int, 2> direction{};
  DoorMask obstructed = 0;
  DoorMask faulty = 0;
  DoorMask jammed = 0;
  bool nudged = false;

  void open(DoorMask doors) { turn(doors, 1); }
  void close(DoorMask doors, DoorClosing closing) {
    nudged = closing == DoorClosing::nudging;
    turn(doors, -1);
  }
  void stop(DoorMask doors) { turn(doors, 0); }
  void turn(DoorMask doors, int way) {
    for (std::size_t door = 0; door < 2; ++door) {
      if ((doors >> door & 1) != 0) direction[door] = way;
    }
  }
  void step() {
    for (std::size_t door = 0; door < 2; ++door) {
      if ((jammed >> door & 1) != 0) continue;
      open_steps[door] = std::clamp(open_steps[door] + direction[door], 0, travel_steps);
    }
  }
  DoorsStatus status() {
    DoorsStatus made{.obstructed = obstructed, .faulty = faulty};
    for (std::size_t door = 0; door < 2; ++door) {
      const auto bit = static_cast<DoorMask>(1U << door);
      if (open_steps[door] == 0 && (faulty & bit) == 0) made.locked |= bit;
      if (open_steps[door] == travel_steps) made.open |= bit;
    }
    return made;
  }
  LiftDoors interface() {
    return {.open = Callback<void(DoorMask)>::to<&BenchDoors::open>(*this),
            .close = Callback<void(DoorMask, DoorClosing)>::to<&BenchDoors::close>(*this),
            .stop = Callback<void(DoorMask)>::to<&BenchDoors::stop>(*this),
            .status = Callback<DoorsStatus()>::to<&BenchDoors::status>(*this)};
  }
};

class LiftBench {
 public:
  static constexpr auto floors = [] {
    std::array<std::int32_t, 10> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<std::int32_t>(i) * 3 * bench_metre;
    }
    return made;
  }();

  explicit LiftBench(LiftControllerSettings settings = {}, unsigned number = 1)
      : device(cable.port(0), 1,
               {.lift = number, .served = {FloorSet::between(1, 10), FloorSet::between(5, 5)}}),
        lift(
            device.node(), device.calls(),
            {car.interface(), doors.interface(), Callback<LiftLoad()>::to<&LiftBench::load>(*this)},
            complete(settings)) {
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

  void step() {
    car.step(doors.open_steps == std::array<int, 2>{});
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
  /// Whether it came to be so in time.
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
  static LiftControllerSettings complete(LiftControllerSettings settings) {
    settings.floors = floors;
    settings.doors = 0b11;
    return settings;
  }
  LiftLoad load() { return weighed; }

  MotionStatus told_motion;
  DoorsStatus told_doors;
  LiftLoad told_load;
};

}  // namespace canvoy::cia417
