// A car that follows a drive elsewhere, by its messages on the bus of its lift: for a position unit
// that is a process of its own, or for a shaft with a real drive.
//
//     CarFollower car(1, Callback<Time()>::to<&World::now>(world));
//     car.hear(frame);  // each frame of the bus
//     CarPositionDevice<> position(port, 4, car.position_hardware());
//
// The velocity is integrated; at the end of a trip the car stands exactly at the target, since the
// drive reports that it does.
#pragma once

#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/devices/cia417/position/car_position_hardware.hpp"

namespace canvoy::lift {

class CarFollower {
 public:
  /// Reads the PDOs of lift `lift`, 1 to 8, at their pre-defined CAN-IDs, in millimetres and mm/s.
  /// The object to which `clock` refers must outlive this one.
  CarFollower(unsigned lift, Callback<Time()> clock, double position_mm = 0)
      : shift_((lift - 1) * 0x10), clock_(clock), position_(position_mm) {}

  /// True if the frame comes from the drive, or is for it.
  bool hear(const Frame& frame);
  /// Encoders of all position units, for a unit elsewhere; valid as long as the follower.
  cia417::CarPositionHardware position_hardware();

  /// State in metres, for CarPlant::lead_by().
  cia417::MotionState motion();
  /// Position above floor 1: the reported one, continued with the reported speed.
  double position_mm() const;
  /// Upward is positive; 0 while the drive is silent.
  double velocity_mm_s() const { return is_silent() ? 0 : velocity_; }

 private:
  cia417::PositionReadings sense(unsigned unit);
  void hear_target(const Frame& frame);
  void hear_status(std::uint16_t status);
  void hear_velocity(double velocity);
  bool moves() const;
  /// True if the drive was silent for so long that it counts as stopped.
  bool is_silent() const { return clock_() - heard_at_ > 2s; }

  std::uint32_t shift_;
  Callback<Time()> clock_;
  double position_;
  double velocity_ = 0;
  double acceleration_ = 0;
  double target_ = 0;
  bool has_target_ = false;
  bool was_moving_ = false;  ///< towards the target
  Time measured_at_{};
  Time heard_at_{};
};

}  // namespace canvoy::lift
