// The sensors and actuators of a car drive unit. The maker of a drive implements it, or a plant in
// a simulation. Positions are increments of the motor's encoder; the factor group (6414h to 641Dh)
// converts them to positions of the car.
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"

namespace canvoy::cia417 {

/// The readings of a drive.
struct DriveReadings {
  double position = 0;         ///< increments
  double velocity = 0;         ///< increments per second, from the position encoder
  double sensor_velocity = 0;  ///< from a velocity encoder, if any; otherwise velocity
  /// True if the home switch is on; nothing if there is none. Homing methods 3 to 14 and 19 to 30
  /// need it.
  std::optional<bool> home_switch = {};
  // Position of the last change of a switch, once it has been passed; nothing before. See
  // HomingMethod.
  std::optional<double> home_position = {};         ///< of the home switch
  std::optional<double> lower_limit_position = {};  ///< of the lower limit switch
  std::optional<double> upper_limit_position = {};  ///< of the upper limit switch
  /// Position of the last passed index pulse.
  std::optional<double> index_position = {};
  /// The power stage has its supply (bit 4 of the statusword): not while the safety chain is open.
  bool voltage = true;
  bool warning = false;     ///< a value is near its limit (bit 7)
  std::uint16_t fault = 0;  ///< an emergency error code of the hardware; 0: none
};

struct CarDriveHardware {
  Callback<DriveReadings()> sense;  ///< at present; called once a period
  /// Switches the power stage, which holds or moves the car; without it, the motor turns freely.
  Callback<void(bool on)> power;
  /// Releases the brake. False: it closes, even if the car still moves.
  Callback<void(bool released)> release_brake;
  /// Sets the movement for the control loop, from `delay` on (the brake opens); before that, its
  /// first state. It holds until the next call; the profile is copied.
  Callback<void(const MotionProfile& profile, Duration delay)> follow;
  /// Sets the velocity controller (6438h): its gain and the time constant of its integral part, in
  /// units of the maker. Called after a reset and when they are written. May be empty.
  Callback<void(std::uint16_t gain, std::uint16_t integration_time)> control = {};
  /// Arrests a car with overspeed or unintended movement, by a device beside the brake: a safety
  /// gear or a rope brake. May be empty.
  Callback<void()> arrest = {};
  /// Self-test of the closed brake, which the drive asks for at each standstill, before it takes
  /// its power away: the motor pushes against the brake as a car with 125 % of its rated load
  /// would. False: the brake slips. May be empty: then nothing is tested (EN 81-20, 5.6.7.3).
  Callback<bool()> brake_holds = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(CarDriveHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::sense; }, "CarDriveHardware needs a member function sense");
  static_assert(
      requires { &Plain::power; }, "CarDriveHardware needs a member function power");
  static_assert(
      requires { &Plain::release_brake; },
      "CarDriveHardware needs a member function release_brake");
  static_assert(
      requires { &Plain::follow; }, "CarDriveHardware needs a member function follow");
  hardware.sense = callback<&Plain::sense>(plain);
  hardware.power = callback<&Plain::power>(plain);
  hardware.release_brake = callback<&Plain::release_brake>(plain);
  hardware.follow = callback<&Plain::follow>(plain);
  if constexpr (requires { &Plain::control; }) hardware.control = callback<&Plain::control>(plain);
  if constexpr (requires { &Plain::arrest; }) hardware.arrest = callback<&Plain::arrest>(plain);
  if constexpr (requires { &Plain::brake_holds; })
    hardware.brake_holds = callback<&Plain::brake_holds>(plain);
}

}  // namespace canvoy::cia417
