// Making the faults of one lift, and mending them.
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
    case FaultKind::fire_brigade:  // people do that, with the keys
      return;
  }
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

bool LiftShaft::is_in_group() const {
  return parts_->controller == nullptr || parts_->controller->is_in_group();
}

ControllerId LiftShaft::controller(NodeId node) const {
  const std::optional<SlotIndex> slot = parts_->slot_of(node);
  return slot ? parts_->world.controller(*slot) : no_controller;
}

Node* LiftShaft::node(NodeId id) {
  if (const Parts::SimulatedNode* simulated = parts_->find(id)) return simulated->node;
  for (const Parts::Panel& panel : parts_->panels) {
    if (panel.description.id == id) return &panel.panel->node();
  }
  return nullptr;
}

}  // namespace canvoy::lift
