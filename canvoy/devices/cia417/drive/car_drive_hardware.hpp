// What a car drive unit senses and drives: the maker of a drive implements it, or a plant in a
// simulation. Positions are increments of the motor's encoder; the factor group (6414h to 641Dh)
// makes positions of the car from them.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"

namespace canvoy::cia417 {

struct DriveReadings {
  double position = 0;         ///< increments
  double velocity = 0;         ///< increments per second, from the position encoder
  double sensor_velocity = 0;  ///< from a velocity encoder where there is one, else the same
  /// Whether the home switch is on; nothing where none tells. Homing methods 3 to 14 and 19 to 30
  /// want it.
  std::optional<bool> home_switch = {};
  // Where a switch switched last, once it has been passed; nothing before. See HomingMethod.
  std::optional<double> home_position = {};
  std::optional<double> lower_limit_position = {};
  std::optional<double> upper_limit_position = {};
  /// The index pulse that was passed last.
  std::optional<double> index_position = {};
  /// The power stage has its supply (bit 4 of the statusword): not while the safety chain is open.
  bool voltage = true;
  bool warning = false;     ///< something is near its limit (bit 7)
  std::uint16_t fault = 0;  ///< an emergency error code of the hardware; 0: none
};

struct CarDriveHardware {
  Callback<DriveReadings()> sense;
  /// The power stage, which holds the car or moves it; without it the motor turns freely.
  Callback<void(bool on)> power;
  /// Without it the brake closes, also where the car still moves.
  Callback<void(bool released)> release_brake;
  /// What the control loop is to follow, from `delay` on (the brake opens); before, its first
  /// state. Holds until the next one; the profile is copied.
  Callback<void(const MotionProfile& profile, Duration delay)> follow;
  /// Of the velocity controller (6438h): its gain and the time constant of its integral part, in
  /// units of the maker; after a reset and when they are written. May be left empty.
  Callback<void(std::uint16_t gain, std::uint16_t integration_time)> control = {};
  /// Overspeed, or the car moves where it should stand: what is there beside the brake, a safety
  /// gear or a rope brake. May be left empty.
  Callback<void()> arrest = {};
};

}  // namespace canvoy::cia417
