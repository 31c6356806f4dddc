// The door of a car as its electronics senses and drives it: the maker of a door drive implements
// it, or a plant in a simulation (canvoy/sim/lift/door_plant.hpp).
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia417/doors.hpp"

namespace canvoy::cia417 {

/// One look at a door. What is not installed is not available.
struct DoorReadings {
  bool is_closed = false;  ///< the limit switch at that end
  bool is_open = false;    ///< and at the other one, of the width that was asked for
  bool has_fault = false;  ///< the drive cannot move it
  /// Between the closing edges; nothing where it is not measured.
  std::optional<std::uint16_t> position_mm{};
  Detection force_limit = Detection::not_available;
  Detection motion = Detection::not_available;
  Detection finger = Detection::not_available;
  Detection lock = Detection::not_available;            ///< yes: locked
  Detection safety_contact = Detection::not_available;  ///< yes: closed
  Detection battery = Detection::not_available;         ///< yes: it is used
  /// Of a light barrier that is wired to the door, and is no device of its own.
  Detection light_barrier = Detection::not_available;
};

/// What the drive of a door is to do.
struct DoorDrive {
  enum class Motion : std::uint8_t { none, close, open };

  Motion motion = Motion::none;
  bool has_torque = false;   ///< without motion: it holds the door where it is
  bool limits_force = true;  ///< to what does not hurt
  bool is_reduced = false;   ///< the speed
  std::uint8_t velocity_profile = 0;
  std::uint8_t width_profile = 0;

  friend constexpr bool operator==(const DoorDrive&, const DoorDrive&) = default;
};

struct DoorHardware {
  Callback<DoorReadings(Time)> sense;
  Callback<void(const DoorDrive&, Time)> drive;
  /// Where there is a lock: locks, or unlocks.
  Callback<void(bool, Time)> lock;
  Callback<void(bool)> use_battery;
  /// When the readings will change by themselves, other than the position: never where nothing
  /// moves. A simulation knows it, and is asked at that time; a real door has no such function, and
  /// is looked at each sensing_period.
  Callback<Time()> next_change;
};

}  // namespace canvoy::cia417
