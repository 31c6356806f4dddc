// Making the faults of one lift, and mending them.
#include <algorithm>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/sim/lift/lift_shaft_parts.hpp"

namespace canvoy::lift {

namespace {

/// What a panel sends without end: a virtual input that is none.
Frame babble_of(NodeId node) {
  return Frame::data_frame(0x480U + node, {0, 0, 0, 0, 0, 0});
}

}  // namespace

const LiftShaft::Parts::SimulatedNode* LiftShaft::Parts::find(NodeId id) const {
  for (const SimulatedNode& node : nodes) {
    if (node.description.id == id) return &node;
  }
  return nullptr;
}

std::optional<SlotIndex> LiftShaft::Parts::slot_of(NodeId id) const {
  if (const SimulatedNode* node = find(id)) return node->slot;
  for (const Panel& panel : panels) {
    if (panel.description.id == id) return panel.panel->slot();
  }
  return std::nullopt;
}

NodeId LiftShaft::Parts::node_of(const ScheduledFault& fault) const {
  const auto named_or = [&](DeviceKind kind) {
    return fault.node != 0 ? fault.node : id_of(kind).value_or(0);
  };
  switch (fault.kind) {
    case FaultKind::lost_node:
      return named_or(DeviceKind::drive);
    case FaultKind::cable_cut:
      return named_or(DeviceKind::lift_controller);
    case FaultKind::babbling_node:
      return named_or(DeviceKind::car_panel);
    case FaultKind::light_barrier:
      return id_of(DeviceKind::light_barrier).value_or(0);
    case FaultKind::dead_encoder:
      return id_of(DeviceKind::position).value_or(0);
    case FaultKind::stuck_button: {
      const Panel* const panel = panel_of(stuck_button(fault));
      return panel == nullptr ? NodeId{0} : panel->description.id;
    }
    case FaultKind::finger_protector:
    case FaultKind::motion_detector:
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
      return named_or(DeviceKind::door);
    case FaultKind::rope_sensor:
      return id_of(DeviceKind::load).value_or(0);
    case FaultKind::smoke:
      return id_of(DeviceKind::light_barrier).value_or(0);
    case FaultKind::brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      return id_of(DeviceKind::drive).value_or(0);
    case FaultKind::fire_alarm:
    case FaultKind::fire_brigade:
      break;
  }
  return 0;
}

void LiftShaft::Parts::set_lost(const ScheduledFault& fault, bool present) {
  const NodeId id = node_of(fault);
  const std::optional<SlotIndex> slot = slot_of(id);
  if (!slot) return;
  const SimulatedNode* const node = find(id);
  // A controller has both of its nodes, or none.
  const bool is_controller = node != nullptr && &*node == nodes.data() + controller_node;
  if (is_controller && group_slot) present ? world.stop(*group_slot) : world.start(*group_slot);
  if (present) {
    world.stop(*slot);
    // Without its electronics a drive has no power stage, and its brake closes.
    if (node == nullptr || node->description.kind != DeviceKind::drive) return;
    const cia417::CarDriveHardware stage = car.drive_hardware();
    stage.release_brake(false);
    stage.power(false);
  } else {
    world.start(*slot);
  }
}

/// Behind the node that is named; behind the controller, which is at the end of the cable.
void LiftShaft::Parts::set_cut(const ScheduledFault& fault, bool present) {
  const std::optional<SlotIndex> slot = slot_of(node_of(fault));
  SimulatedBus& cable = world.bus(bus);
  if (!present) return cable.mend_cable();
  if (slot) cable.cut_cable(world.controller(*slot));
}

CallKey LiftShaft::Parts::stuck_button(const ScheduledFault& fault) const {
  const FloorNumber main = description.building.main_floor;
  const bool is_at_main = fault.floor == main;
  if (fault.floor == no_floor) return {.lift = lift, .floor = main};
  if (description.service.destination_control) {
    const FloorNumber other = main == 1 ? 2 : 1;
    return {.floor = fault.floor, .to = is_at_main ? other : main};
  }
  return {.floor = fault.floor, .direction = is_at_main ? Direction::up : Direction::down};
}

void LiftShaft::Parts::set_stuck(const ScheduledFault& fault, bool present) {
  const CallKey button = stuck_button(fault);
  const Panel* const panel = panel_of(button);
  if (panel == nullptr) return;
  const std::optional<std::size_t> input = panel->panel->find(input_of(button));
  if (input) panel->panel->stick(*input, present);
}

void LiftShaft::Parts::set_babbling(const ScheduledFault& fault, bool present) {
  const NodeId id = node_of(fault);
  const std::optional<SlotIndex> slot = slot_of(id);
  if (!slot) return;
  SimulatedBus& cable = world.bus(bus);
  const ControllerId of = world.controller(*slot);
  if (present) {
    cable.babble(of, babble_of(id));
  } else {
    cable.stop_babbling(of);
  }
}

/// It stays where it was, and knows it.
void LiftShaft::Parts::set_dead_encoder(bool present) {
  CarPlantFaults faults = car.faults();
  faults.position_encoder_is_dead = present;
  faults.position_encoder_alarms = present;
  car.set_faults(faults);
}

LiftShaft::Parts::Door* LiftShaft::Parts::door_of(const ScheduledFault& fault) {
  const SimulatedNode* const unit = find(node_of(fault));
  for (const auto& door : doors) {
    if (unit != nullptr && door->unit == static_cast<std::size_t>(unit - nodes.data())) {
      return door.get();
    }
  }
  return nullptr;
}

void LiftShaft::Parts::set_door(const ScheduledFault& fault, bool present) {
  Door* const door = door_of(fault);
  if (door == nullptr) return;
  DoorFaults faults = door->plant.faults();
  if (fault.kind == FaultKind::finger_protector) faults.finger_protector_is_broken = present;
  if (fault.kind == FaultKind::motion_detector) faults.motion_detector_is_broken = present;
  if (fault.kind == FaultKind::door_lock) faults.lock_is_open = present;
  if (fault.kind == FaultKind::safety_contact) faults.contact_is_broken = present;
  door->plant.set_faults(now(), faults);
  look_again(door->unit, door->unit_changed);
}

void LiftShaft::Parts::set_car(const ScheduledFault& fault, bool present) {
  constexpr double slip_share = 0.1;
  CarPlantFaults faults = car.faults();
  if (fault.kind == FaultKind::brake) faults.brake_share = present ? 0 : 1;
  if (fault.kind == FaultKind::rope_slip) faults.slip = present ? slip_share : 0;
  if (fault.kind == FaultKind::runaway) faults.motor_runs_away = present;
  car.set_faults(faults);
}

/// Who mends the last thing that is broken pulls the car off its safety gear, and closes what only
/// a hand closes.
void LiftShaft::Parts::reset_by_hand() {
  const CarPlantFaults& broken = car.faults();
  const bool is_whole = broken.brake_share == 1 && broken.slip == 0 && !broken.motor_runs_away;
  const bool are_doors_whole = std::ranges::none_of(doors, [](const auto& door) {
    return door->plant.faults().lock_is_open || door->plant.faults().contact_is_broken;
  });
  if (!is_whole || !are_doors_whole) return kick();
  car.release_gear();
  chain.reset_by_hand();
  kick();
}

void LiftShaft::set_fault(const ScheduledFault& fault, bool present) {
  Parts& parts = *parts_;
  switch (fault.kind) {
    case FaultKind::lost_node:
      return parts.set_lost(fault, present);
    case FaultKind::cable_cut:
      return parts.set_cut(fault, present);
    case FaultKind::stuck_button:
      return parts.set_stuck(fault, present);
    case FaultKind::light_barrier:
      parts.barrier_is_broken = present;
      return parts.look_again(parts.barrier, parts.barrier_changed);
    case FaultKind::dead_encoder:
      return parts.set_dead_encoder(present);
    case FaultKind::babbling_node:
      return parts.set_babbling(fault, present);
    case FaultKind::fire_alarm:
      return turn_fire_key(present);
    case FaultKind::finger_protector:
    case FaultKind::motion_detector:
      return parts.set_door(fault, present);
    case FaultKind::door_lock:
    case FaultKind::safety_contact:
      parts.set_door(fault, present);
      return present ? parts.kick() : parts.reset_by_hand();
    case FaultKind::brake:
    case FaultKind::rope_slip:
    case FaultKind::runaway:
      parts.set_car(fault, present);
      return present ? parts.kick() : parts.reset_by_hand();
    case FaultKind::rope_sensor:
      parts.cell.break_sensor(present ? 1 : 0);
      return parts.look_again(parts.load, parts.load_changed);
    case FaultKind::smoke:
      parts.barrier_is_covered = present;
      return parts.look_again(parts.barrier, parts.barrier_changed);
    case FaultKind::fire_brigade:  // people do that, with the keys
      return;
  }
}

bool LiftShaft::would_drift() const {
  return parts_->car.would_drift();
}

NodeId LiftShaft::node_of(const ScheduledFault& fault) const {
  return parts_->node_of(fault);
}

bool LiftShaft::has_stuck_button(const ScheduledFault& fault) const {
  return parts_->panel_of(parts_->stuck_button(fault)) != nullptr;
}

std::optional<SlotIndex> LiftShaft::group_slot() const {
  return parts_->group_slot;
}

std::optional<SlotIndex> LiftShaft::slot(NodeId node) const {
  return parts_->slot_of(node);
}

Node* LiftShaft::node(NodeId id) {
  if (const Parts::SimulatedNode* simulated = parts_->find(id)) return simulated->node;
  for (const Parts::Panel& panel : parts_->panels) {
    if (panel.description.id == id) return &panel.panel->node();
  }
  return nullptr;
}

}  // namespace canvoy::lift
