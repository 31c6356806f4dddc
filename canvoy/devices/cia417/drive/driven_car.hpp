// The car as its drive moves it: power stage, brake, and the profile that the control loop follows;
// what the encoder tells of it, whether it stands, and where (CiA 417-4, 4.11).
//
//     DrivenCar car(hardware, 200ms, led);
//     car.switch_power(true);
//     car.follow(MotionProfile::to_position(car.present(now), 12'500, ramps), now);
//     car.sense(now, parameters.windows(), jitter);  // each period
//     if (car.has_ended(now) && car.is_standing()) car.close_brake();
//
// The brake opens when a profile begins that moves the car, and the profile begins when the brake
// is open. It closes when it is told to, also where the car still moves.
#pragma once

#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"
#include "canvoy/devices/cia417/drive/drive_parameters.hpp"
#include "canvoy/devices/cia417/drive/lasting.hpp"

namespace canvoy::cia417 {

class DrivenCar {
 public:
  /// The brake takes `brake_time` to open. `led` is called when the car follows another profile.
  DrivenCar(const CarDriveHardware& hardware, Duration brake_time, Callback<void()> led)
      : hardware_(hardware), brake_time_(brake_time), led_(led) {}

  /// Nothing that was seen before counts any longer; power and brake are as they were.
  void begin_anew();
  /// An encoder that comes back tells another position at once: what it changes by more than
  /// `jitter`, and than it can have moved, is no movement. In increments.
  void sense(Time now, const DriveWindows& windows, double jitter);
  const DriveReadings& readings() const { return readings_; }

  /// What the control loop is to do now.
  MotionState demand(Time now) const { return profile_.at(seconds_since_start(now)); }
  /// Where the car is to be now; without power, where it is.
  MotionState present(Time now) const;
  /// Of the profile; negative: it has ended so long ago.
  double seconds_left(Time now) const { return profile_.duration() - seconds_since_start(now); }
  bool has_ended(Time now) const { return seconds_left(now) <= 0; }
  /// Out of the way of the profile, in increments; 0 behind the brake.
  double lag(Time now) const;

  bool has_power() const { return has_power_; }
  bool is_brake_released() const { return brake_released_; }
  /// Below the velocity threshold, for its time.
  bool is_slow() const { return is_slow_; }
  /// Slow, and nothing moves it.
  bool is_standing() const { return is_standing_; }
  /// So many increments from where it came to stand behind its brake.
  bool has_strayed(double distance) const;
  /// It is to stand where it is now.
  void settle() { stood_at_ = readings_.position; }

  void switch_power(bool on);
  void follow(const MotionProfile& profile, Time now);
  /// To a stop within `limits`.
  void slow_down(const MotionLimits& limits, Time now);
  /// Holds the car by its power stage.
  void hold(Time now);
  void close_brake();
  /// By what is there beside the brake.
  void arrest() { hardware_.arrest(); }
  /// Of the velocity controller (6438h).
  void tune(std::uint16_t gain, std::uint16_t integration_time) {
    hardware_.control(gain, integration_time);
  }

 private:
  double seconds_since_start(Time now) const {
    return std::chrono::duration<double>(now - start_).count();
  }
  void release_brake();

  CarDriveHardware hardware_;
  Duration brake_time_;
  Callback<void()> led_;
  DriveReadings readings_;
  MotionProfile profile_;
  Time start_{};  ///< of the profile
  Time measured_at_{};
  Lasting slow_;
  double stood_at_ = 0;  ///< where it came to stand behind its brake
  bool has_power_ = false;
  bool brake_released_ = false;
  bool is_slow_ = false;
  bool is_standing_ = false;
  bool has_stood_ = false;  ///< since the brake closed
};

}  // namespace canvoy::cia417
