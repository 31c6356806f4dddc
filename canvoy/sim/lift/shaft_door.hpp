// A door of a car: its plant, who stands in it, what is broken, and the unit that senses it.
//
//     ShaftDoor door(design, true, moved);
//     device(port, id, door.hardware());
//     door.has_unit(id, ChangeSignal(world, slot, changed));
//     door.stand_in_way(now, true);
#pragma once

#include <array>
#include <memory>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/change_signal.hpp"
#include "canvoy/sim/lift/door_plant.hpp"
#include "canvoy/sim/lift/fault.hpp"

namespace canvoy::lift {

class ShaftDoor {
 public:
  /// `is_there`: the car has it. `moved` is told when its unit orders something.
  ShaftDoor(const DoorDesign& design, bool is_there, Callback<void()> moved);
  ShaftDoor(const ShaftDoor&) = delete;
  ShaftDoor& operator=(const ShaftDoor&) = delete;

  /// For its unit; valid as long as this.
  cia417::DoorHardware hardware();
  void has_unit(NodeId id, ChangeSignal unit);
  /// 0: it is not simulated here.
  NodeId unit() const { return unit_id_; }

  bool is_there() const { return is_there_; }
  const DoorPlant& plant() const { return plant_; }
  /// People, or whoever a real light barrier sees.
  bool is_blocked() const { return has_somebody_ || is_barred_; }
  bool has_somebody() const { return has_somebody_; }

  /// People stand in it, or not any more.
  void stand_in_way(Time now, bool is_in_way);
  /// A real light barrier sees somebody.
  void bar(Time now, bool is_barred);
  /// A real door unit says so.
  void lead(Time now, const cia417::DoorReport& said, std::optional<std::uint16_t> position_mm) {
    plant_.lead(now, said, position_mm);
  }
  /// One of a door (is_of_door()).
  void set_fault(Time now, FaultKind kind, bool present);
  /// Nothing of it is broken that opens the safety chain.
  bool is_whole() const {
    return !plant_.faults().lock_is_open && !plant_.faults().contact_is_broken;
  }

 private:
  void drive(const cia417::DoorDrive& order, Time at);
  void lock(bool locks, Time at);
  void look_again(Time now);

  DoorPlant plant_;
  cia417::DoorHardware behind_ = plant_.hardware();
  Callback<void()> moved_;
  bool is_there_;
  NodeId unit_id_ = 0;
  ChangeSignal unit_;
  bool has_somebody_ = false;
  bool is_barred_ = false;
};

/// Door 1 first.
using ShaftDoors = std::array<std::unique_ptr<ShaftDoor>, doors_max>;
ShaftDoors doors_of(const LiftDesign& design, Callback<void()> moved);

}  // namespace canvoy::lift
