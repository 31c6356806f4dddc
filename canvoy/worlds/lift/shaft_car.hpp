// The car of a lift with the safety chain that guards it, and with its drive: its own, or a real
// one elsewhere.
//
//     ShaftCar car(building, 1, clock);
//     device(port, id, car.plant().drive_hardware());
//     car.look_at_chain(now, doors);
//     car.set_fault(FaultKind::brake, true);
#pragma once

#include <utility>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/car_follower.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "canvoy/worlds/lift/change_signal.hpp"
#include "canvoy/worlds/lift/fault.hpp"
#include "canvoy/worlds/lift/safety_chain.hpp"
#include "canvoy/worlds/lift/shaft_door.hpp"

namespace canvoy::lift {

class ShaftCar {
 public:
  /// `building`, and the object to which `clock` refers, must outlive this object.
  ShaftCar(const Building& building, LiftNumber lift, Callback<Time()> clock);
  ShaftCar(const ShaftCar&) = delete;
  ShaftCar& operator=(const ShaftCar&) = delete;

  /// The car in its shaft.
  CarPlant& plant() { return plant_; }
  /// The car in its shaft.
  const CarPlant& plant() const { return plant_; }
  /// The drive unit reads its inputs again when `unit` tells it.
  void has_drive_unit(ChangeSignal unit) { drive_ = std::move(unit); }
  /// Follows a real drive, and so receives all frames of the bus.
  void follow_real_drive();
  /// True if the frame comes from that drive, or is for it.
  bool hear(const Frame& frame) { return real_.hear(frame); }

  /// The part of the safety chain that must be reset by hand.
  SafetyChain::Trip trip() const {
    return chain_.is_closed() ? SafetyChain::Trip::none : chain_.trip();
  }
  /// Updates the safety chain, and with it what the drive may do.
  void look_at_chain(Time now, const ShaftDoors& doors);
  /// Opens the safety chain by a stop switch, or closes it again.
  void press_stop(bool is_pressed) { is_stopped_by_hand_ = is_pressed; }
  /// Moves the car by hand, off its safety gear; at 0, the gear catches it again if it had. False:
  /// the car follows a real drive, and is moved there.
  bool crank(double metre_per_second);
  /// True if it moves although its brake is closed.
  static bool drifts(const CarPlant::Truth& car) {
    return car.brake_is_closed && car.velocity_m_s != 0;
  }
  /// True if its motor runs away, or its brake holds nothing.
  bool is_unheld() const {
    return plant_.faults().motor_runs_away || plant_.faults().brake_share == 0;
  }
  /// Floor where it stands, or which it passes; no_floor: between two.
  FloorNumber floor();

  /// A drive without its electronics has no power stage, and its brake closes.
  void lose_drive();
  /// Begins or ends a fault of drive, brake, ropes or encoder.
  void set_fault(FaultKind kind, bool present);
  /// True if drive, brake and ropes are in order.
  bool is_whole() const;
  /// Pulls the car off its safety gear, and closes what must be closed by hand.
  void reset_by_hand();
  /// Closes what the self-test of the brake has opened.
  void reset_brake();

 private:
  SafetySight sight(Time now, const ShaftDoors& doors);

  const Building* building_;
  CarPlant plant_;
  SafetyChain chain_;
  CarFollower real_;
  ChangeSignal drive_;
  bool is_stopped_by_hand_ = false;
  bool is_cranked_ = false;
  bool has_no_brake_ = false;
  bool has_weak_brake_ = false;
  bool is_led_ = false;      ///< follows a real drive
  bool was_caught_ = false;  ///< by its gear, before it was cranked
};

}  // namespace canvoy::lift
