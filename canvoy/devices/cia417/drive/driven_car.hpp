// The car of a drive: power stage, brake, the profile of the control loop, and the state from the
// encoder: position, and whether it stands (CiA 417-4, 4.11).
//
//     DrivenCar car(hardware, 200ms, led);
//     car.switch_power(true);
//     car.follow(MotionProfile::to_position(car.present(now), 12'500, ramps), now);
//     car.sense(now, parameters.windows(), jitter);  // each period
//     if (car.has_ended(now) && car.is_standing()) car.close_brake();
//
// The brake opens when a profile starts that moves the car, and the profile starts when the brake
// is open. The brake closes on command, even if the car still moves.
#pragma once

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"
#include "canvoy/devices/cia417/drive/drive_parameters.hpp"

namespace canvoy::cia417 {

/// Checks whether a condition has held without a break for a time: a velocity window (6435h to
/// 6437h), a following error.
///
///     Lasting slow;
///     slow.watch(speed < threshold, now);       // each time that it was measured
///     if (slow.lasts(100ms, now)) ...
class Lasting {
 public:
  /// Takes whether the condition holds at present.
  void watch(bool is_so, Time now) {
    if (!is_so) {
      since_ = never;
    } else if (since_ == never) {
      since_ = now;
    }
  }
  /// True if it has held for `time`, until now.
  bool lasts(Duration time, Time now) const { return since_ != never && now - since_ >= time; }
  /// Starts again: it has not held.
  void begin_anew() { since_ = never; }

 private:
  Time since_ = never;
};

class DrivenCar {
 public:
  /// The brake takes `brake_time` to open. `led` is called when the car gets another profile.
  DrivenCar(const CarDriveHardware& hardware, Duration brake_time, Callback<void()> led)
      : hardware_(hardware), brake_time_(brake_time), led_(led) {}

  /// Discards all readings; power and brake stay as they are.
  void begin_anew();
  /// Takes the readings. An encoder that returns may report a position jump: a change by more than
  /// `jitter` and more than the car can have moved is no movement. In increments.
  void sense(Time now, const DriveWindows& windows, double jitter);
  /// What the hardware reported last.
  const DriveReadings& readings() const { return readings_; }

  /// Demanded state of the control loop at present.
  MotionState demand(Time now) const { return profile_.at(seconds_since_start(now)); }
  /// Demanded position of the car at present; without power, its real position.
  MotionState present(Time now) const;
  /// Remaining time of the profile; negative: time since its end.
  double seconds_left(Time now) const { return profile_.duration() - seconds_since_start(now); }
  /// True at the end of the profile and after it.
  bool has_ended(Time now) const { return seconds_left(now) <= 0; }
  /// Deviation from the profile, in increments; 0 with the closed brake.
  double lag(Time now) const;

  /// True while the power stage is on.
  bool has_power() const { return has_power_; }
  /// True while the brake is open, or opens.
  bool is_brake_released() const { return brake_released_; }
  /// True if the brake slipped at its last self-test.
  bool has_weak_brake() const { return has_weak_brake_; }
  /// Discards that result, after a fault reset.
  void forget_brake_test() { has_weak_brake_ = false; }
  /// True if it has been below the velocity threshold for its time.
  bool is_slow() const { return is_slow_; }
  /// True if it is slow, and no profile moves it.
  bool is_standing() const { return is_standing_; }
  /// True at this distance in increments from its standstill with the closed brake.
  bool has_strayed(double distance) const;
  /// Takes the present position as that of its standstill.
  void settle() { stood_at_ = readings_.position; }

  /// Switches the power stage; without it the motor turns freely.
  void switch_power(bool on);
  /// Moves the car by a profile, from the opening of the brake on.
  void follow(const MotionProfile& profile, Time now);
  /// Slows down to a stop within `limits`.
  void slow_down(const MotionLimits& limits, Time now);
  /// Holds the car with the power stage.
  void hold(Time now);
  /// Closes the brake at once, even if the car moves.
  void close_brake();
  /// Arrests the car by the device beside the brake.
  void arrest() { hardware_.arrest(); }
  /// Sets the velocity controller (6438h).
  void tune(std::uint16_t gain, std::uint16_t integration_time) {
    hardware_.control(gain, integration_time);
  }

 private:
  double seconds_since_start(Time now) const {
    return std::chrono::duration<double>(now - start_).count();
  }
  void release_brake();
  void test_brake();

  CarDriveHardware hardware_;
  Duration brake_time_;
  Callback<void()> led_;
  DriveReadings readings_;
  MotionProfile profile_;
  Time start_{};  ///< of the profile
  Time measured_at_{};
  Lasting slow_;
  double stood_at_ = 0;  ///< position of the standstill with the closed brake
  bool has_power_ = false;
  bool brake_released_ = false;
  bool has_weak_brake_ = false;
  bool is_slow_ = false;
  bool is_standing_ = false;
  bool has_stood_ = false;  ///< since the brake closed
};

}  // namespace canvoy::cia417
