// Profile position mode of a car drive: set-points (6420h) that are acknowledged, queued behind the
// present one, and reached (CiA 417-4, 4.11.1 and 4.11.4; bits 4 to 6 of 6400h, 10 to 12 of 6401h).
//
//     ProfilePositionMode mode(car, parameters, 2);
//     mode.take(0x003F, 12'500, false, now);     // acknowledged: bit 12
//     if (mode.look(now) == true) ...            // each period: bit 10
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

/// Profile velocity mode of a car drive: the velocity of 6430h, within 6408h, and within the
/// software limits of the position (6422h), before which the car stops (CiA 417-4, 4.11.1).
///
///     ProfileVelocityMode mode(car, parameters, 20ms);
///     mode.obey(630, now);
///     mode.look(now);              // each period: bit 10, the velocity is there
class ProfileVelocityMode {
 public:
  /// look() is called every `period` while the car moves. All references must outlive this.
  ProfileVelocityMode(DrivenCar& car, const DriveParameters& parameters, Duration period)
      : car_(car), parameters_(parameters), period_(period) {}
  ProfileVelocityMode(const ProfileVelocityMode&) = delete;
  ProfileVelocityMode& operator=(const ProfileVelocityMode&) = delete;

  /// Starts without a velocity, and without a limit.
  void begin_anew();
  /// Applies the demanded velocity again, even if it is unchanged.
  void ask_again() { obeyed_.reset(); }
  /// Ends the movement: the car is stopped.
  void give_up() { goal_ = 0; }
  /// `target` is the value of 6430h. False if it applies already.
  bool obey(std::int32_t target, Time now);
  /// True if the velocity has been within its window for the window time (6435h).
  bool look(Time now);

  /// True if the car is slower than demanded, or does not move.
  bool is_limited() const { return is_limited_; }
  /// Call it after each reading of the car.
  void watch_slippage(Time now);
  /// True if the velocity differs by more than the maximum slippage (6437h) from that of the
  /// control loop.
  bool slips() const { return slips_; }

 private:
  void watch_position_limit(Time now);

  DrivenCar& car_;
  const DriveParameters& parameters_;
  Duration period_;
  double goal_ = 0;  ///< in increments per second
  Lasting near_;     ///< near the goal
  std::optional<std::int32_t> obeyed_;
  bool is_limited_ = false;
  bool slips_ = false;
};

/// Profile position mode of a car drive.
class ProfilePositionMode {
 public:
  /// The car has arrived within this distance from its target, in units of position. All references
  /// must outlive this.
  ProfilePositionMode(DrivenCar& car, DriveParameters& parameters, double window)
      : car_(car), parameters_(parameters), window_(window) {}
  ProfilePositionMode(const ProfilePositionMode&) = delete;
  ProfilePositionMode& operator=(const ProfilePositionMode&) = delete;

  /// Starts without a set-point, and without an acknowledged one.
  void begin_anew();
  /// Ends all travels: the car is stopped.
  void give_up();
  /// Takes a change of bit 4 of the controlword: its rising edge makes `target` (6420h) a
  /// set-point. True if the car starts. A halted car does not: see go_on().
  bool take(std::uint16_t word, std::int32_t target, bool is_halted, Time now);
  /// Continues after a halt.
  void go_on(Time now);
  /// Returns true when the car has reached its target, and false when it starts for the next one;
  /// nothing without a change.
  std::optional<bool> look(Time now);

  /// True from the take-over of a set-point to the falling edge of bit 4 (bit 12).
  bool is_acknowledged() const { return is_acknowledged_; }
  /// True if the set-point is beyond a software limit (6422h), at which the car stops.
  bool is_limited() const { return is_limited_; }

 private:
  double wanted_position(std::int32_t target, bool is_relative, Time now);
  bool wait_behind(double target, bool is_halted, Time now);
  void travel(double target, double velocity_there, Time now);

  DrivenCar& car_;
  DriveParameters& parameters_;
  double window_;
  double target_ = 0;           ///< of the travel, in increments
  std::optional<double> next_;  ///< queued behind it
  bool is_travelling_ = false;
  bool is_acknowledged_ = false;
  bool is_limited_ = false;
};

}  // namespace canvoy::cia417
