// Profile velocity mode of a car drive: the velocity of 6430h, within 6408h, and within the
// software limits of the position (6422h), before which the car stops (CiA 417-4, 4.11.1).
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

}  // namespace canvoy::cia417
