#include "canvoy/worlds/lift/shaft_door.hpp"

#include <utility>

namespace canvoy::lift {

ShaftDoor::ShaftDoor(const DoorDesign& design, bool is_there, Callback<void()> moved)
    : plant_({.width_m = design.width_m,
              .open_time_s = design.open_time_s,
              .close_time_s = design.close_time_s}),
      moved_(moved),
      is_there_(is_there) {}

cia417::DoorHardware ShaftDoor::hardware() {
  cia417::DoorHardware made = behind_;
  made.drive = callback<&ShaftDoor::drive>(*this);
  made.lock = callback<&ShaftDoor::lock>(*this);
  return made;
}

void ShaftDoor::has_unit(NodeId id, ChangeSignal unit) {
  unit_id_ = id;
  unit_ = std::move(unit);
}

void ShaftDoor::drive(const cia417::DoorDrive& order, Time at) {
  behind_.drive(order, at);
  moved_();
}

void ShaftDoor::lock(bool locks, Time at) {
  behind_.lock(locks, at);
  moved_();
}

void ShaftDoor::stand_in_way(Time now, bool is_in_way) {
  has_somebody_ = is_in_way;
  look_again(now);
}

void ShaftDoor::put_in_way(Time now, bool is_in_way) {
  has_thing_ = is_in_way;
  look_again(now);
}

void ShaftDoor::approach(bool is_near) {
  plant_.approach(is_near);
  unit_.tell();
}

void ShaftDoor::touch_edge(bool is_touched) {
  plant_.touch_edge(is_touched);
  unit_.tell();
}

void ShaftDoor::bar(Time now, bool is_barred) {
  is_barred_ = is_barred;
  look_again(now);
}

void ShaftDoor::look_again(Time now) {
  plant_.stand_in_way(now, is_blocked());
  unit_.tell();
}

void ShaftDoor::set_fault(Time now, FaultKind kind, bool present) {
  using Faults = DoorFaults;
  if (kind == FaultKind::finger_protector) {
    set_fault(now, &Faults::finger_protector_is_broken, present);
  }
  if (kind == FaultKind::motion_detector) {
    set_fault(now, &Faults::motion_detector_is_broken, present);
  }
  if (kind == FaultKind::door_lock) set_fault(now, &Faults::lock_is_open, present);
  if (kind == FaultKind::safety_contact) set_fault(now, &Faults::contact_is_broken, present);
}

void ShaftDoor::set_fault(Time now, bool DoorFaults::*fault, bool present) {
  DoorFaults faults = plant_.faults();
  faults.*fault = present;
  plant_.set_faults(now, faults);
  unit_.tell();
}

ShaftDoors doors_of(const LiftDesign& design, Callback<void()> moved) {
  ShaftDoors doors;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    const bool is_there = (design.doors >> i & 1U) != 0;
    doors.at(i) = std::make_unique<ShaftDoor>(design.door, is_there, moved);
  }
  return doors;
}

}  // namespace canvoy::lift
