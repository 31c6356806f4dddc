// Commands of a lift controller to the doors and the drive of its car, and their status:
// LiftController has no other access to them. CarDoorController and CarDriveController implement
// these interfaces; a test or a simulation may do so as well.
//
//     LiftController lift(node, {.motion = drive.motion(), .doors = doors.doors()}, settings);
//     drive.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     doors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//
// The implementation calls LiftController::update() whenever a status has changed. Positions are
// micrometres upwards from a point of the shaft that the installer selects.
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia417 {

/// Doors of a car; bit 0 is door 1.
using DoorMask = std::uint8_t;

/// State of the doors of a car together.
struct DoorsStatus {
  /// Closed, locked, and with closed safety contact.
  DoorMask locked = 0;
  /// Open to the end.
  DoorMask open = 0;
  /// On the way to open or closed.
  DoorMask moving = 0;
  /// An obstacle is in the way: light barrier, finger protector, motion detector, or the force
  /// limit.
  DoorMask obstructed = 0;
  /// The door reports an error, or is not received.
  DoorMask faulty = 0;
  /// Its light barrier reports an error, or is not received: the door may touch a person.
  DoorMask unprotected = 0;

  friend constexpr bool operator==(const DoorsStatus&, const DoorsStatus&) = default;
};

/// How a door closes.
enum class DoorClosing : std::uint8_t {
  normal,   ///< with limited force; an obstacle makes the door open again
  gentle,   ///< like normal, at reduced speed: its light barrier is broken
  nudging,  ///< at reduced speed, regardless of the light barrier
};

/// Commands to the doors of a car.
struct LiftDoors {
  /// Unlocks and opens; closing doors reverse.
  Callback<void(DoorMask)> open;
  Callback<void(DoorMask, DoorClosing)> close;  ///< closes doors
  /// Stops at the present position.
  Callback<void(DoorMask)> stop;
  Callback<DoorsStatus()> status;  ///< state at present; cheap, called often
};

/// State of a car and its drive.
struct MotionStatus {
  /// Drive and position unit are received, and have no error.
  bool available = false;
  /// It neither moves nor has a command to move: the brake holds the car.
  bool standing = true;
  /// It stands at the target of the last travel_to().
  bool arrived = false;
  std::int32_t position_micrometre = 0;  ///< above the zero of the position unit
  /// Positive upwards.
  std::int32_t velocity_micrometre_per_second = 0;
  /// The first position in its direction where the car could come to rest as at a floor; its
  /// present position while it stands.
  std::int32_t stopping_position_micrometre = 0;

  friend constexpr bool operator==(const MotionStatus&, const MotionStatus&) = default;
};

/// Commands to the drive of a car.
struct LiftMotion {
  /// Moves there and stops. If it already moves in the same direction, and the target is beyond the
  /// stopping position, it continues without a stop.
  Callback<void(std::int32_t position_micrometre)> travel_to;
  /// Moves at constant speed until the next command: service run and dogging.
  Callback<void(std::int32_t velocity_micrometre_per_second)> run;
  /// Slows down as at a floor, and stands.
  Callback<void()> stop;
  /// Stops as fast as possible (CiA 402: quick stop).
  Callback<void()> fast_stop;
  Callback<MotionStatus()> status;  ///< state at present; cheap, called often
};

}  // namespace canvoy::cia417
