#include "canvoy/sim/excavator/excavator_faults.hpp"

namespace canvoy::excavator {

namespace {

NodeId place_of_fault(const ScheduledFault& fault) {
  if (fault.kind == FaultKind::vanished_armrest) return armrest_id;
  if (!has_node(fault.kind)) return 0;
  return fault.node == 0 ? host_id : fault.node;
}

Stick axis_of_fault(const ScheduledFault& fault) {
  return static_cast<Stick>(fault.axis == 0 ? stick_count - 1 : fault.axis - 1);
}

}  // namespace

ExcavatorFaults::ExcavatorFaults(World& world, BusIndex bus, const ExcavatorOptions& options,
                                 ExcavatorDevices& devices, SeatPanel& panel,
                                 ExcavatorReferees& referees, std::vector<ExcavatorEvent>& events)
    : world_(&world),
      bus_(bus),
      options_(&options),
      devices_(&devices),
      panel_(&panel),
      referees_(&referees),
      events_(&events),
      trouble_(world.bus(bus)),
      cuts_(PowerCuts::Switch::to<&ExcavatorFaults::power>(*this)) {
  for (std::size_t i = 0; i < options.faults.faults.size(); ++i) {
    const ScheduledFault& fault = options.faults.faults[i];
    if (fault.kind == FaultKind::babbling_node) trouble_.attach_babbler();
    world.at(fault.start, [this, i](Time) { begin(i); });
    if (fault.end() != never) world.at(fault.end(), [this, i](Time) { end(i); });
  }
}

unsigned& ExcavatorFaults::count_of(const ScheduledFault& fault) {
  const auto kind = static_cast<std::size_t>(fault.kind);
  if (has_axis(fault.kind)) return at_axis_[kind][static_cast<std::size_t>(axis_of_fault(fault))];
  return at_node_[kind][place_of_fault(fault)];
}

void ExcavatorFaults::begin(std::size_t fault) {
  const ScheduledFault& it = options_->faults.faults[fault];
  const NodeId id = place_of_fault(it);
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_begins(now, it.kind);
  if (++count_of(it) == 1 || !lasts(it.kind)) set(it, true);
}

void ExcavatorFaults::end(std::size_t fault) {
  const ScheduledFault& it = options_->faults.faults[fault];
  const NodeId id = place_of_fault(it);
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_ends(now, it.kind);
  // Another one of the same kind may last longer.
  if (--count_of(it) == 0) set(it, false);
}

void ExcavatorFaults::set(const ScheduledFault& fault, bool present) {
  SimulatedBus& bus = world_->bus(bus_);
  const NodeId id = place_of_fault(fault);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return cuts_.set_power(id, !present);
    case FaultKind::restart:
      return present ? cuts_.restart(id) : void();
    case FaultKind::bus_off:
      bus.set_bit_rate(devices_->node(id).controller(),
                       present ? options_->bit_rate / 2 : options_->bit_rate);
      return present ? void() : bus.recover(devices_->node(id).controller());
    case FaultKind::cable_cut:
      return cut_cables();
    case FaultKind::babbling_node:
      return trouble_.babble(present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(present ? options_->faults.corrupted_share : 0);
    case FaultKind::lost_frames:
      return devices_->node(id).port().lose(Probability(present ? options_->faults.lost_share : 0));
    case FaultKind::delayed_frames:
      return devices_->node(id).port().delay(present ? options_->faults.delay : Duration{});
    case FaultKind::stuck_axis:
      panel_->jam(axis_of_fault(fault), present);
      return devices_->hands_moved();
    case FaultKind::broken_wire:
      panel_->break_wire(axis_of_fault(fault), present);
      return devices_->hands_moved();
    case FaultKind::vanished_armrest:
      return cuts_.set_power(armrest_id, !present);
  }
}

/// All that are cut now.
void ExcavatorFaults::cut_cables() {
  SimulatedBus& bus = world_->bus(bus_);
  bus.mend_cable();
  for (const auto& node : devices_->nodes()) {
    const auto& cuts = at_node_[static_cast<std::size_t>(FaultKind::cable_cut)];
    if (cuts[node->place().id] != 0) bus.cut_cable(node->controller());
  }
}

}  // namespace canvoy::excavator
