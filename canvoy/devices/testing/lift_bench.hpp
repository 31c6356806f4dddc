// A simple simulated car and its doors, for tests and fuzzers: 1 m/s without acceleration, doors
// that take 2 s, in steps of 10 ms.
//
//     BenchCar car;
//     BenchDoors doors;
//     LiftController lift(node, calls, {car.interface(), doors.interface()}, settings);
//     car.step(doors.are_closed());
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>

#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"

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
  unsigned runs = 0;            ///< number of commands to move at constant speed
  std::int32_t run_margin = 0;  ///< micrometres: the car rests so far short of its position
  bool left_unlocked = false;   ///< it moved with a door that was not locked

  void travel_to(std::int32_t position) {
    target = position;
    is_driving = position != motion.position_micrometre;
    motion.arrived = !is_driving;
    motion.standing = !is_driving;
  }
  void run(std::int32_t speed) {
    ++runs;
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
      motion.stopping_position_micrometre =
          motion.position_micrometre + (run_speed > 0 ? run_margin : -run_margin);
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
    return {.travel_to = callback<&BenchCar::travel_to>(*this),
            .run = callback<&BenchCar::run>(*this),
            .stop = callback<&BenchCar::stop>(*this),
            .fast_stop = callback<&BenchCar::fast_stop>(*this),
            .status = callback<&BenchCar::status>(*this)};
  }
};

/// Two doors.
struct BenchDoors {
  static constexpr int travel_steps = 200;  // 2 s

  std::array<int, 2> open_steps{};
  std::array<int, 2> direction{};
  DoorMask obstructed = 0;
  DoorMask faulty = 0;
  DoorMask unprotected = 0;
  DoorMask jammed = 0;
  bool nudged = false;
  DoorClosing closing = DoorClosing::normal;  ///< as last commanded

  void open(DoorMask doors) { turn(doors, 1); }
  void close(DoorMask doors, DoorClosing how) {
    nudged = how == DoorClosing::nudging;
    closing = how;
    turn(doors, -1);
  }
  void stop(DoorMask doors) { turn(doors, 0); }
  void turn(DoorMask doors, int way) {
    for (std::size_t door = 0; door < 2; ++door) {
      if ((doors >> door & 1) != 0) direction[door] = way;
    }
  }
  bool are_closed() const { return open_steps == std::array<int, 2>{}; }
  void step() {
    for (std::size_t door = 0; door < 2; ++door) {
      if ((jammed >> door & 1) != 0) continue;
      open_steps[door] = std::clamp(open_steps[door] + direction[door], 0, travel_steps);
    }
  }
  DoorsStatus status() {
    DoorsStatus made{.obstructed = obstructed, .faulty = faulty, .unprotected = unprotected};
    for (std::size_t door = 0; door < 2; ++door) {
      const auto bit = static_cast<DoorMask>(1U << door);
      if (open_steps[door] == 0 && (faulty & bit) == 0) made.locked |= bit;
      if (open_steps[door] == travel_steps) made.open |= bit;
    }
    return made;
  }
  LiftDoors interface() {
    return {.open = callback<&BenchDoors::open>(*this),
            .close = callback<&BenchDoors::close>(*this),
            .stop = callback<&BenchDoors::stop>(*this),
            .status = callback<&BenchDoors::status>(*this)};
  }
};

}  // namespace canvoy::cia417
