// A simple simulated door for tests: it runs at constant speed between closed and 900 mm.
//
//     DoorBench bench;
//     CarDoorDevice<> door(cable.port(0), 6, {bench.hardware()});
//     bench.force_limit = Detection::yes;  door.unit().hardware_changed();
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "canvoy/devices/cia417/door/car_door_hardware.hpp"

namespace canvoy::cia417 {

struct DoorBench {
  static constexpr double width_mm = 900;
  static constexpr double speed_mm_per_s = 300;  ///< half of it at reduced speed

  double position_mm = 0;
  Time at{};
  DoorDrive driven;
  bool is_blocked = false;  ///< it does not move, even when driven
  bool is_locked = false;
  bool lock_is_stuck = false;
  bool uses_battery = false;
  bool has_fault = false;
  Detection force_limit = Detection::no;
  Detection motion = Detection::no;
  Detection finger = Detection::no;
  Detection light_barrier = Detection::not_available;
  std::vector<DoorDrive> orders;

  double speed() const {
    if (is_blocked || driven.motion == DoorDrive::Motion::none) return 0;
    const double value = driven.is_reduced ? speed_mm_per_s / 2 : speed_mm_per_s;
    return driven.motion == DoorDrive::Motion::open ? value : -value;
  }
  void run_to(Time now) {
    const double seconds = std::chrono::duration<double>(now - at).count();
    position_mm = std::clamp(position_mm + speed() * seconds, 0.0, width_mm);
    at = now;
  }

  DoorReadings sense(Time now) {
    run_to(now);
    const bool is_closed = position_mm < 0.5;
    return {.is_closed = is_closed,
            .is_open = position_mm > width_mm - 0.5,
            .has_fault = has_fault,
            .position_mm = static_cast<std::uint16_t>(std::lround(position_mm)),
            .force_limit = force_limit,
            .motion = motion,
            .finger = finger,
            .lock = is_locked ? Detection::yes : Detection::no,
            .safety_contact = is_closed ? Detection::yes : Detection::no,
            .battery = uses_battery ? Detection::yes : Detection::no,
            .light_barrier = light_barrier};
  }
  void drive(const DoorDrive& order, Time now) {
    run_to(now);
    driven = order;
    orders.push_back(order);
  }
  void lock(bool locks, Time /*now*/) {
    if (!lock_is_stuck) is_locked = locks;
  }
  void use_battery(bool uses) { uses_battery = uses; }
  Time next_change() {
    const double way = speed() > 0 ? width_mm - position_mm : position_mm;
    if (speed() == 0 || way < 0.5) return never;
    return at + Duration(std::llround(std::ceil(way / std::abs(speed()) * 1e6)));
  }

  DoorHardware hardware() {
    using Self = DoorBench;
    return {.sense = callback<&Self::sense>(*this),
            .drive = callback<&Self::drive>(*this),
            .lock = callback<&Self::lock>(*this),
            .use_battery = callback<&Self::use_battery>(*this),
            .next_change = callback<&Self::next_change>(*this)};
  }
};

}  // namespace canvoy::cia417
