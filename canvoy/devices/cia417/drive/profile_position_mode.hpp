// Profile position mode of a car drive: set-points (6420h) that are acknowledged, wait behind the
// one that is travelled to, and are reached (CiA 417-4, 4.11.1 and 4.11.4; bits 4 to 6 of 6400h, 10
// to 12 of 6401h).
//
//     ProfilePositionMode mode(car, parameters, 2);
//     mode.take(0x003F, 12'500, false, now);     // acknowledged: bit 12
//     if (mode.look(now) == true) ...            // each period: bit 10
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

class ProfilePositionMode {
 public:
  /// So near to its target, in units of position, the car has arrived. What is referred to must
  /// outlive this.
  ProfilePositionMode(DrivenCar& car, DriveParameters& parameters, double window)
      : car_(car), parameters_(parameters), window_(window) {}
  ProfilePositionMode(const ProfilePositionMode&) = delete;
  ProfilePositionMode& operator=(const ProfilePositionMode&) = delete;

  /// Without a set-point, and none acknowledged.
  void begin_anew();
  /// The car is stopped: it travels nowhere.
  void give_up();
  /// Bit 4 of the controlword has changed: its rising edge makes `target` (6420h) a set-point.
  /// True: the car sets off. A halted one does not: see go_on().
  bool take(std::uint16_t word, std::int32_t target, bool is_halted, Time now);
  /// After a halt.
  void go_on(Time now);
  /// Whether the car has reached its target, where that is news: false sets off for the next one.
  std::optional<bool> look(Time now);

  bool is_acknowledged() const { return is_acknowledged_; }
  /// The set-point lies behind a software limit (6422h), at which the car stops.
  bool is_limited() const { return is_limited_; }

 private:
  double wanted_position(std::int32_t target, bool is_relative, Time now);
  bool wait_behind(double target, bool is_halted, Time now);
  void travel(double target, double velocity_there, Time now);

  DrivenCar& car_;
  DriveParameters& parameters_;
  double window_;
  double target_ = 0;           ///< of the travel, in increments
  std::optional<double> next_;  ///< waits behind it
  bool is_travelling_ = false;
  bool is_acknowledged_ = false;
  bool is_limited_ = false;
};

}  // namespace canvoy::cia417
