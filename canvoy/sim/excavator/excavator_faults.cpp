// Making the faults of the plan, and mending them.
#include "canvoy/sim/excavator/excavator_network.hpp"

namespace canvoy::excavator {

namespace {

/// An NMT command of the wrong length: nobody obeys it, and nothing has a higher priority.
constexpr Frame excavator_babble{.id = can_id::nmt, .length = Frame::length_max};

NodeId place_of_fault(const ScheduledFault& fault) {
  if (fault.kind == FaultKind::vanished_armrest) return armrest_id;
  if (!has_node(fault.kind)) return 0;
  return fault.node == 0 ? host_id : fault.node;
}

Stick axis_of_fault(const ScheduledFault& fault) {
  return static_cast<Stick>(fault.axis == 0 ? stick_count - 1 : fault.axis - 1);
}

}  // namespace

void ExcavatorNetwork::plan_faults() {
  for (std::size_t i = 0; i < options_.faults.faults.size(); ++i) {
    const ScheduledFault& fault = options_.faults.faults[i];
    if (fault.kind == FaultKind::babbling_node && babbler_ == no_controller) {
      babbler_ = world_.bus(bus_).attach({});
      world_.bus(bus_).power(babbler_, false);
    }
    world_.at(fault.start, [this, i](Time) { begin(i); });
    if (fault.end() != never) world_.at(fault.end(), [this, i](Time) { end(i); });
  }
}

void ExcavatorNetwork::begin(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  const NodeId id = place_of_fault(it);
  note(now(), FaultBegan{fault, it.kind, {.bus = bus_of(id), .node = id}});
  had_fault_ = true;
  referee_.fault_begins(affected_by(it.kind));
  if (!lasts(it.kind)) referee_.fault_ends(affected_by(it.kind), now());
  const auto kind = static_cast<std::size_t>(it.kind);
  unsigned& count = has_axis(it.kind) ? at_axis_[kind][static_cast<std::size_t>(axis_of_fault(it))]
                                      : at_node_[kind][id];
  if (++count == 1 || !lasts(it.kind)) set_fault(it, true);
}

void ExcavatorNetwork::end(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  const NodeId id = place_of_fault(it);
  note(now(), FaultEnded{fault, it.kind, {.bus = bus_of(id), .node = id}});
  if (lasts(it.kind)) referee_.fault_ends(affected_by(it.kind), now());
  const auto kind = static_cast<std::size_t>(it.kind);
  unsigned& count = has_axis(it.kind) ? at_axis_[kind][static_cast<std::size_t>(axis_of_fault(it))]
                                      : at_node_[kind][id];
  // Another one of the same kind may last longer.
  if (--count == 0) set_fault(it, false);
}

void ExcavatorNetwork::set_fault(const ScheduledFault& fault, bool present) {
  SimulatedBus& bus = world_.bus(bus_);
  const NodeId id = place_of_fault(fault);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return set_power(id, !present);
    case FaultKind::restart:
      if (present && without_power_.at(id) == 0) {
        power(node(id), false);
        power(node(id), true);
      }
      return;
    case FaultKind::bus_off:
      bus.set_bit_rate(node(id).controller(), present ? options_.bit_rate / 2 : options_.bit_rate);
      return present ? void() : bus.recover(node(id).controller());
    case FaultKind::cable_cut:
      return cut_cables();
    case FaultKind::babbling_node:
      bus.power(babbler_, present);
      return present ? bus.babble(babbler_, excavator_babble) : bus.stop_babbling(babbler_);
    case FaultKind::corrupted_frames:
      return bus.set_frame_error_probability(present ? options_.faults.corrupted_share : 0);
    case FaultKind::lost_frames:
      return node(id).port().lose(Probability(present ? options_.faults.lost_share : 0));
    case FaultKind::delayed_frames:
      return node(id).port().delay(present ? options_.faults.delay : Duration{});
    case FaultKind::stuck_axis:
      panel_.jam(axis_of_fault(fault), present);
      return hands_moved();
    case FaultKind::broken_wire:
      panel_.break_wire(axis_of_fault(fault), present);
      return hands_moved();
    case FaultKind::vanished_armrest:
      return set_power(armrest_id, !present);
  }
}

/// All that are cut now.
void ExcavatorNetwork::cut_cables() {
  SimulatedBus& bus = world_.bus(bus_);
  bus.mend_cable();
  for (const auto& node : nodes_) {
    const auto& cuts = at_node_[static_cast<std::size_t>(FaultKind::cable_cut)];
    if (cuts[node->place().id] != 0) bus.cut_cable(node->controller());
  }
}

/// Two faults may keep a device from its power; it has it again when both are over.
void ExcavatorNetwork::set_power(NodeId id, bool is_on) {
  unsigned& without = without_power_.at(id);
  if (is_on ? --without == 0 : ++without == 1) power(node(id), is_on);
}

}  // namespace canvoy::excavator
