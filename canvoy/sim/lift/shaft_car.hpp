// The car of a shaft with its counterweight, motor and brake, as its drive moves it: positions in
// closed form at any time, energy from the work that is done.
//
//     ShaftCar car(lift, [&] { return world.now(); }, changed);
//     CarDriveDevice<> drive(port, 2, car.hardware());
//     car.at(now).position;   // metres above floor 1
#pragma once

#include <functional>
#include <optional>

#include "canvoy/devices/cia417/car_drive_hardware.hpp"
#include "canvoy/sim/lift/building.hpp"

namespace canvoy::lift {

class ShaftCar {
 public:
  /// Increments of the motor's encoder on a millimetre of the car's way: those of the drive.
  static constexpr double increments_per_m = 10'000;

  /// `changed` is called when the car begins to move in another way.
  ShaftCar(const LiftDesign& design, std::function<Time()> clock, std::function<void()> changed);
  ShaftCar(const ShaftCar&) = delete;
  ShaftCar& operator=(const ShaftCar&) = delete;

  cia417::CarDriveHardware hardware();
  void set_load(double mass_kg) { load_kg_ = mass_kg; }
  void place(double position_m);

  /// In metres above floor 1, and seconds.
  cia417::MotionState at(Time now) const;
  bool is_moving(Time now) const;
  /// The brake has closed on a car that moved.
  bool is_braking(Time now) const;
  /// Sums what has been consumed and travelled since it was called last: at least each 100 ms
  /// while the car moves.
  void account(Time now);
  double energy_wh() const { return energy_j_ / 3600; }
  double distance_m() const { return distance_m_; }
  double load_kg() const { return load_kg_; }

  /// What the encoder of the motor does not do any more.
  bool encoder_is_dead = false;

 private:
  cia417::DriveReadings sense();
  void switch_power(bool on);
  void release_brake(bool released);
  void follow(const cia417::MotionProfile& profile, Time start);
  void brake();
  double seconds_since(Time start, Time now) const;

  LiftDesign design_;
  std::function<Time()> clock_;
  std::function<void()> changed_;
  cia417::MotionProfile profile_{};  ///< in increments; follows it from start_ on
  Time start_{};
  bool has_power_ = false;
  bool is_released_ = false;
  bool is_braked_ = false;  ///< profile_ is that of the brake
  double load_kg_ = 0;
  double energy_j_ = 0;
  double distance_m_ = 0;
  Time accounted_at_{};
  double accounted_position_m_ = 0;
};

}  // namespace canvoy::lift
