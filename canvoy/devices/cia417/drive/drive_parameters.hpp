// The parameters of a car drive unit: its units in increments and seconds (CiA 417-4, 4.11.3), its
// ramps (4.11.1), and values that are not allowed.
//
//     DriveParameters parameters(node.dictionary(), 1);
//     parameters.read();
//     MotionProfile::to_position(now, parameters.units().position * 12500, parameters.ramps());
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/devices/cia417/drive/drive_state.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"

namespace canvoy::cia417 {

/// Increments of the motor's encoder, and their changes per second, in one unit of the objects.
/// Negative where 641Eh reverses it.
struct DriveUnits {
  double position = 1;         ///< increments
  double velocity = 1;         ///< increments per second
  double acceleration = 1;     ///< increments per second squared
  double jerk = 1;             ///< increments per second cubed
  double sensor_velocity = 1;  ///< in one unit of 6431h, in increments per second
};

/// Times and widths of 6435h to 6437h, as increments per second.
struct DriveWindows {
  double velocity_window = 0;               ///< around the target velocity
  Duration velocity_window_time{};          ///< to have been in it
  double velocity_threshold = 0;            ///< below: standstill
  Duration velocity_threshold_time{};       ///< to have been below
  std::optional<double> max_slippage = {};  ///< nothing: not limited
};

/// Deceleration of a motor on its current and on its voltage limit, in units of 640Ah.
struct MotorLimits {
  double current_deceleration = 2500;  ///< on its current limit
  double voltage_deceleration = 2000;  ///< on its voltage limit
};

class DriveParameters {
 public:
  /// `dictionary` must outlive this; `lift` is 1 to 8.
  DriveParameters(Dictionary& dictionary, unsigned lift, const MotorLimits& motor = {})
      : dictionary_(&dictionary),
        shift_(static_cast<std::uint16_t>((lift - 1) * 0x800)),
        motor_(motor) {}

  /// Reads the values of the dictionary. Call it after a reset and after writes.
  void read();

  /// Increments of one unit.
  const DriveUnits& units() const { return units_; }
  /// Converts units of position.
  double increments(double positions) const { return positions * std::abs(units_.position); }
  /// Widths and times of velocities.
  const DriveWindows& windows() const { return windows_; }
  /// Ramp of travels and of stops on the slow-down ramp (6423h, 640Bh, 640Dh).
  const MotionLimits& ramps() const { return ramps_; }
  /// Ramp with the bends E and F, from the end velocity to a stop.
  const MotionLimits& final_ramp() const { return final_ramp_; }
  /// Ramp of the quick stop (640Ah), without jerk.
  const MotionLimits& quick_stop() const { return quick_stop_; }
  /// Ramp of an option code that stops a car of this speed (6402h); not for `disable`, where the
  /// brake stops it.
  MotionLimits stop_ramp(cia402::StopReaction reaction, double velocity) const;
  /// Increments per second, by 6408h; 0: not limited.
  double velocity_max() const { return velocity_max_; }
  /// Velocity with which the car arrives at a set-point, in increments per second.
  double end_velocity() const { return end_velocity_; }
  /// Software limits (6422h), in increments from the home position.
  double position_min() const { return position_min_; }
  /// The upper software limit.
  double position_max() const { return position_max_; }
  /// The equivalent position within the range of 6421h, both in units. The two ends of the range
  /// are adjacent.
  double in_range(double position) const;
  /// In increments: the home position, the reference of software limits, and the position 0.
  double home() const { return home_; }
  /// Position 0 of the objects, in increments.
  double zero() const { return zero_; }
  /// Counts positions from here on from these, after homing.
  void count_from(double home, double zero);

  /// Reaction that 6402h selects by this sub-index.
  cia402::StopReaction option(unsigned sub) const;
  /// Distance of position 0 from the home position, in units.
  std::int64_t home_offset() const { return number(0x6428, 0); }
  /// Setting of the velocity controller (6438h).
  std::uint16_t gain() const { return static_cast<std::uint16_t>(number(0x6438, 1)); }
  /// Time constant of the velocity controller, in units of the maker.
  std::uint16_t integration_time() const { return static_cast<std::uint16_t>(number(0x6438, 2)); }

  /// True for modes and targets: these are no parameters, and may be written at any time.
  bool is_command(const Entry& entry) const;
  /// Abort code of a value that an entry may not have at present; `relative` is bit 6 of the
  /// controlword. Configuration is refused while the drive has power (4.11).
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value, DriveState state,
                  bool relative) const;

 private:
  std::int64_t number(std::uint16_t index, std::uint8_t sub) const;
  double magnitude(std::uint16_t index, std::uint8_t sub) const;
  double ratio(std::uint16_t index) const;
  double power_of_ten(std::uint16_t index) const;
  bool has(std::uint16_t index, std::uint8_t sub) const;

  DriveUnits read_units() const;
  double read_velocity_max() const;
  DriveWindows read_windows() const;
  unsigned jerks_used() const;
  double jerk(std::uint8_t sub) const;
  void read_ramps();
  void read_positions();

  AbortCode check_option(unsigned sub, std::int64_t wanted) const;
  AbortCode check_ramp(const Entry& entry, std::uint16_t index, std::int64_t wanted) const;
  AbortCode check_range(std::uint16_t index, unsigned sub, std::int64_t wanted) const;
  AbortCode check_target(std::int64_t wanted) const;
  AbortCode check_velocity(std::int64_t wanted) const;

  Dictionary* dictionary_;
  std::uint16_t shift_;
  MotorLimits motor_;
  DriveUnits units_;
  DriveWindows windows_;
  MotionLimits ramps_;
  MotionLimits final_ramp_;
  MotionLimits quick_stop_;
  double velocity_max_ = 0;
  double end_velocity_ = 0;
  double position_min_ = 0;
  double position_max_ = 0;
  double home_ = 0;
  double zero_ = 0;
  double zero_above_home_ = 0;  ///< in the units at the time when it was found
};

}  // namespace canvoy::cia417
