// A car that follows a drive which is elsewhere: by what the drive says on the bus of its lift. For
// a position unit that is a process of its own, or a shaft whose drive is a real one.
//
//     CarFollower car(1, Callback<Time()>::to<&World::now>(world));
//     car.hear(frame);  // each frame of the bus
//     CarPositionDevice<> position(port, 4, car.position_hardware());
//
// The velocity is summed up; at the end of a trip the car stands at the target, to the millimetre,
// since the drive says that it does.
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
  /// It hears the PDOs of lift `lift`, 1 to 8, at their pre-defined CAN-IDs, in millimetres and
  /// mm/s. What `clock` refers to must outlive this.
  CarFollower(unsigned lift, Callback<Time()> clock, double position_mm = 0)
      : shift_((lift - 1) * 0x10), clock_(clock), position_(position_mm) {}

  /// Whether the frame was of the drive, or for it.
  bool hear(const Frame& frame);
  cia417::CarPositionHardware position_hardware();

  /// In metres, for CarPlant::lead_by().
  cia417::MotionState motion();
  double position_mm() const;
  double velocity_mm_s() const { return is_silent() ? 0 : velocity_; }

 private:
  cia417::PositionReadings sense(unsigned unit);
  void hear_target(const Frame& frame);
  void hear_status(std::uint16_t status);
  void hear_velocity(double velocity);
  /// A drive that has said nothing for so long has stopped.
  bool is_silent() const { return clock_() - heard_at_ > 2s; }

  std::uint32_t shift_;
  Callback<Time()> clock_;
  double position_;
  double velocity_ = 0;
  double acceleration_ = 0;
  double target_ = 0;
  bool has_target_ = false;
  bool was_moving_ = false;  ///< towards it
  Time measured_at_{};
  Time heard_at_{};
};

}  // namespace canvoy::lift
