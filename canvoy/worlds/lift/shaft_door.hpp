// A door of a car: its plant, people in it, its defects, and the unit that senses it.
//
//     ShaftDoor door(design, true, moved);
//     device(port, id, door.hardware());
//     door.has_unit(id, ChangeSignal(world, slot, changed));
//     door.stand_in_way(now, true);
#pragma once

#include <array>
#include <memory>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/change_signal.hpp"
#include "canvoy/worlds/lift/door_plant.hpp"
#include "canvoy/worlds/lift/fault.hpp"

namespace canvoy::lift {

class ShaftDoor {
 public:
  /// `is_there`: the car has this door. `moved` is called when its unit commands something.
  ShaftDoor(const DoorDesign& design, bool is_there, Callback<void()> moved);
  ShaftDoor(const ShaftDoor&) = delete;
  ShaftDoor& operator=(const ShaftDoor&) = delete;

  /// Hardware for its unit; valid as long as this object.
  cia417::DoorHardware hardware();
  /// Its unit is a node here, and reads its inputs when `unit` tells it.
  void has_unit(NodeId id, ChangeSignal unit);
  /// Node-ID of its unit; 0: it is not simulated here.
  NodeId unit() const { return unit_id_; }

  /// True if the car has this door.
  bool is_there() const { return is_there_; }
  /// The panels, lock and contacts.
  const DoorPlant& plant() const { return plant_; }
  /// True if people stand in it, or a real light barrier is interrupted.
  bool is_blocked() const { return has_somebody() || is_barred_; }
  /// True if people or a thing stand in it.
  bool has_somebody() const { return has_somebody_ || has_thing_; }

  /// People stand in it, or leave it.
  void stand_in_way(Time now, bool is_in_way);
  /// A thing stands in it, beside people.
  void put_in_way(Time now, bool is_in_way);
  /// A person is in front of its motion detector.
  void approach(bool is_near);
  /// A finger is where the panels slide in.
  void touch_edge(bool is_touched);
  /// A real light barrier is interrupted, or free.
  void bar(Time now, bool is_barred);
  /// Follows the report of a real door unit.
  void lead(Time now, const cia417::DoorReport& said, std::optional<std::uint16_t> position_mm) {
    plant_.lead(now, said, position_mm);
  }
  /// Begins or ends a fault of a door (is_of_door()).
  void set_fault(Time now, FaultKind kind, bool present);
  /// Begins or ends one defect, by its member of DoorFaults.
  void set_fault(Time now, bool DoorFaults::*fault, bool present);
  /// True if no defect of it opens the safety chain.
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
  bool has_thing_ = false;
  bool is_barred_ = false;
};

/// Door 1 first.
using ShaftDoors = std::array<std::unique_ptr<ShaftDoor>, doors_max>;
/// The doors of a car: those that it does not have are not there.
ShaftDoors doors_of(const LiftDesign& design, Callback<void()> moved);

}  // namespace canvoy::lift
