// The car of a lift with the safety chain that guards it, and whoever leads it: its own drive, or a
// real one elsewhere.
//
//     ShaftCar car(building, 1, clock);
//     device(port, id, car.plant().drive_hardware());
//     car.look_at_chain(now, doors);
//     car.set_fault(FaultKind::brake, true);
#pragma once

#include <utility>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/frame.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/car_follower.hpp"
#include "canvoy/sim/lift/car_plant.hpp"
#include "canvoy/sim/lift/change_signal.hpp"
#include "canvoy/sim/lift/fault.hpp"
#include "canvoy/sim/lift/safety_chain.hpp"
#include "canvoy/sim/lift/shaft_door.hpp"

namespace canvoy::lift {

class ShaftCar {
 public:
  /// `building`, and what `clock` refers to, must outlive this.
  ShaftCar(const Building& building, LiftNumber lift, Callback<Time()> clock);
  ShaftCar(const ShaftCar&) = delete;
  ShaftCar& operator=(const ShaftCar&) = delete;

  CarPlant& plant() { return plant_; }
  const CarPlant& plant() const { return plant_; }
  void has_drive_unit(ChangeSignal unit) { drive_ = std::move(unit); }
  /// A real drive leads it, of which it hears all frames of the bus.
  void follow_real_drive();
  /// Whether the frame was of that drive, or for it.
  bool hear(const Frame& frame) { return real_.hear(frame); }

  /// What of the safety chain only a hand resets.
  SafetyChain::Trip trip() const {
    return chain_.is_closed() ? SafetyChain::Trip::none : chain_.trip();
  }
  /// What the safety chain lets the drive do from now on.
  void look_at_chain(Time now, const ShaftDoors& doors);
  /// It moves although its brake is closed.
  static bool drifts(const CarPlant::Truth& car) {
    return car.brake_is_closed && car.velocity_m_s != 0;
  }
  /// Its motor runs away, or its brake holds nothing.
  bool is_unheld() const {
    return plant_.faults().motor_runs_away || plant_.faults().brake_share == 0;
  }
  /// Where it stands, or passes; no_floor: between two.
  FloorNumber floor();

  /// A drive without its electronics has no power stage, and its brake closes.
  void lose_drive();
  /// Of drive, brake, ropes or encoder.
  void set_fault(FaultKind kind, bool present);
  /// Drive, brake and ropes are.
  bool is_whole() const;
  /// Somebody pulls it off its safety gear, and closes what only a hand closes.
  void reset_by_hand();

 private:
  SafetySight sight(Time now, const ShaftDoors& doors);

  const Building* building_;
  CarPlant plant_;
  SafetyChain chain_;
  CarFollower real_;
  ChangeSignal drive_;
};

}  // namespace canvoy::lift
