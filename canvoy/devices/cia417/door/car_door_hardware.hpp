// The sensors and the drive of a car door. The maker of a door drive implements it, or a plant in a
// simulation (canvoy/worlds/lift/door_plant.hpp).
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/profiles/cia417/doors.hpp"

namespace canvoy::cia417 {

/// The readings of a door. Sensors that are not installed are not available.
struct DoorReadings {
  bool is_closed = false;  ///< the limit switch at that end
  bool is_open = false;    ///< the limit switch at the other end, of the selected width
  bool has_fault = false;  ///< the drive cannot move it
  /// Distance between the closing edges; nothing if it is not measured.
  std::optional<std::uint16_t> position_mm{};
  Detection force_limit = Detection::not_available;     ///< an obstacle, felt by the drive
  Detection motion = Detection::not_available;          ///< someone approaches
  Detection finger = Detection::not_available;          ///< a finger is near the leaf
  Detection lock = Detection::not_available;            ///< yes: locked
  Detection safety_contact = Detection::not_available;  ///< yes: closed
  Detection battery = Detection::not_available;         ///< yes: in use
  /// State of a light barrier that is wired to the door and is no separate device.
  Detection light_barrier = Detection::not_available;
};

/// Command to the drive of a door.
struct DoorDrive {
  /// What the drive does.
  enum class Motion : std::uint8_t { none, close, open };

  Motion motion = Motion::none;       ///< none: it stands
  bool has_torque = false;            ///< without motion: it holds the door where it is
  bool limits_force = true;           ///< to a harmless value
  bool is_reduced = false;            ///< the speed
  std::uint8_t velocity_profile = 0;  ///< number of the profile, 6304h:01h
  std::uint8_t width_profile = 0;     ///< number of the profile, 6304h:02h

  friend constexpr bool operator==(const DoorDrive&, const DoorDrive&) = default;
};

/// The functions of a door; all are called in calls of the node.
struct DoorHardware {
  Callback<DoorReadings(Time)> sense;            ///< the readings at this time
  Callback<void(const DoorDrive&, Time)> drive;  ///< the command, from this time on
  /// Locks or unlocks, if there is a lock.
  Callback<void(bool, Time)> lock;
  Callback<void(bool)> use_battery;  ///< true: from now on; without one, no effect
  /// Time of the next change of the readings, apart from the position: never if nothing moves. A
  /// simulation has this function, and is read at that time. A real door leaves it empty, and is
  /// read every sensing_period.
  Callback<Time()> next_change;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(DoorHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::sense; }, "DoorHardware needs a member function sense");
  static_assert(
      requires { &Plain::drive; }, "DoorHardware needs a member function drive");
  hardware.sense = callback<&Plain::sense>(plain);
  hardware.drive = callback<&Plain::drive>(plain);
  if constexpr (requires { &Plain::lock; }) hardware.lock = callback<&Plain::lock>(plain);
  if constexpr (requires { &Plain::use_battery; })
    hardware.use_battery = callback<&Plain::use_battery>(plain);
  if constexpr (requires { &Plain::next_change; })
    hardware.next_change = callback<&Plain::next_change>(plain);
}

}  // namespace canvoy::cia417
