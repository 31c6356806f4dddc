// How a lift controller commands the doors and the drive of its car, and sees what they do: all
// that LiftController knows of them. CarDoorController and CarDriveController fill these, a test or
// a simulation may as well.
//
//     LiftController lift(node, {.motion = drive.motion(), .doors = doors.doors()}, settings);
//     drive.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     doors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//
// Whoever fills one calls LiftController::update() whenever a status has changed. Positions are
// micrometres upwards from a point of the shaft that the installer chose.
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"

namespace canvoy::cia417 {

/// Doors of a car, bit 0 is door 1.
using DoorMask = std::uint8_t;

struct DoorsStatus {
  /// Closed, locked, and with closed safety contact.
  DoorMask locked = 0;
  /// Open as far as they go.
  DoorMask open = 0;
  /// On the way to open or closed.
  DoorMask moving = 0;
  /// Somebody or something is in the way: light barrier, finger protector, motion detector, or the
  /// force limit.
  DoorMask obstructed = 0;
  /// The door tells of an error, or is not heard.
  DoorMask faulty = 0;
  /// Its light barrier does, or is not heard: nothing keeps it from meeting somebody.
  DoorMask unprotected = 0;

  friend constexpr bool operator==(const DoorsStatus&, const DoorsStatus&) = default;
};

enum class DoorClosing : std::uint8_t {
  normal,   ///< with limited force; an obstacle makes the door open again
  gentle,   ///< the same at reduced speed: its light barrier is broken
  nudging,  ///< at reduced speed, whatever the light barrier says
};

struct LiftDoors {
  /// Unlocks and opens; doors that are closing turn round.
  Callback<void(DoorMask)> open;
  Callback<void(DoorMask, DoorClosing)> close;
  /// Where they are.
  Callback<void(DoorMask)> stop;
  Callback<DoorsStatus()> status;
};

struct MotionStatus {
  /// Drive and position unit are heard, and have no error.
  bool available = false;
  /// Neither moves nor was told to: the brake holds the car.
  bool standing = true;
  /// Standing where the last travel_to() wanted it.
  bool arrived = false;
  std::int32_t position_micrometre = 0;
  /// Upwards positive.
  std::int32_t velocity_micrometre_per_second = 0;
  /// The first position in its direction where the car could come to rest as it does at a floor;
  /// where it is, while it stands.
  std::int32_t stopping_position_micrometre = 0;

  friend constexpr bool operator==(const MotionStatus&, const MotionStatus&) = default;
};

struct LiftMotion {
  /// Goes there and stops; while it moves already, in the same direction and beyond the stopping
  /// position, it goes on without a stop.
  Callback<void(std::int32_t position_micrometre)> travel_to;
  /// Moves at constant speed until told otherwise: service run and dogging.
  Callback<void(std::int32_t velocity_micrometre_per_second)> run;
  /// Slows down as at a floor, and stands.
  Callback<void()> stop;
  /// Stands as soon as it can (CiA 402: quick stop).
  Callback<void()> fast_stop;
  Callback<MotionStatus()> status;
};

}  // namespace canvoy::cia417
