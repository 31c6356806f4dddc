// Profile velocity mode of a car drive: the velocity that 6430h asks for, within 6408h, and within
// the software limits of the position (6422h), before which the car stops (CiA 417-4, 4.11.1).
//
//     ProfileVelocityMode mode(car, parameters, 20ms);
//     mode.obey(630, now);
//     mode.look(now);              // each period: bit 10, the velocity is there
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

class ProfileVelocityMode {
 public:
  /// look() is called each `period` while the car moves. What is referred to must outlive this.
  ProfileVelocityMode(DrivenCar& car, const DriveParameters& parameters, Duration period)
      : car_(car), parameters_(parameters), period_(period) {}
  ProfileVelocityMode(const ProfileVelocityMode&) = delete;
  ProfileVelocityMode& operator=(const ProfileVelocityMode&) = delete;

  /// Nothing is asked for, and nothing was limited.
  void begin_anew();
  /// What is asked for counts anew, also where it is the same.
  void ask_again() { obeyed_.reset(); }
  /// The car is stopped.
  void give_up() { goal_ = 0; }
  /// `target` is the value of 6430h. False: that is obeyed already.
  bool obey(std::int32_t target, Time now);
  /// Whether the velocity has been within its window for the time of that (6435h).
  bool look(Time now);

  /// The car goes more slowly than it was asked, or not at all.
  bool is_limited() const { return is_limited_; }
  /// Each time that the car was sensed.
  void watch_slippage(Time now);
  /// By more than the maximum slippage (6437h) from what the control loop is to do.
  bool slips() const { return slips_; }

 private:
  void watch_position_limit(Time now);

  DrivenCar& car_;
  const DriveParameters& parameters_;
  Duration period_;
  double goal_ = 0;  ///< in increments per second
  Lasting near_;     ///< to the goal
  std::optional<std::int32_t> obeyed_;
  bool is_limited_ = false;
  bool slips_ = false;
};

}  // namespace canvoy::cia417
