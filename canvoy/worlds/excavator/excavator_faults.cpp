#include "canvoy/worlds/excavator/excavator_faults.hpp"

namespace canvoy::excavator {

namespace {

using Kind = InvariantKind;

constexpr double lost_share = 0.05;  ///< lost_frames: share of the frames of a node
constexpr Duration frame_delay = 20ms;

InvariantSet set_of(std::initializer_list<Kind> kinds) {
  InvariantSet set;
  for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

Stick axis_of(const ScheduledFault& fault) {
  return static_cast<Stick>(spot_of(fault) - 1);
}

}  // namespace

/// Sensors that disagree are found by the seat.
InvariantSet affected_at_first(FaultKind kind) {
  return kind == FaultKind::drifting_axis ? set_of({Kind::axis_delta}) : InvariantSet{};
}

/// Never the invariant of motion: the machine stops, whatever happens.
InvariantSet affected_by(FaultKind kind) {
  switch (kind) {
    case FaultKind::corrupted_frames:
      return {};
    case FaultKind::delayed_frames:
      return set_of({Kind::axis_delta});
    case FaultKind::stuck_axis:
    case FaultKind::broken_wire:
      return set_of({Kind::axis_delta, Kind::service, Kind::spilled});
    case FaultKind::drifting_axis:
      return set_of({Kind::service, Kind::spilled});
    case FaultKind::vanished_armrest:
    case FaultKind::emergency_stop:
    case FaultKind::seat_switch:
      return set_of({Kind::presses, Kind::service, Kind::spilled});
    default:
      return set_of({Kind::presses, Kind::axis_delta, Kind::indicators, Kind::display,
                     Kind::service, Kind::spilled, Kind::device_missing});
  }
}

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
      faults_(options.faults.faults, Engine::of(*this)),
      cuts_(PowerCuts::Switch::to<&ExcavatorFaults::power>(*this)) {
  if (faults_.has_any(FaultKind::babbling_node)) trouble_.attach_babbler();
  faults_.plan(world);
}

void ExcavatorFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const NodeId id = node_of(it);
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_begins(now, it.kind);
}

void ExcavatorFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  const NodeId id = node_of(it);
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, it.kind, {.bus = devices_->bus_of(id), .node = id}}});
  referees_->fault_ends(now, it.kind);
}

void ExcavatorFaults::set(std::size_t number, bool present) {
  const ScheduledFault& fault = faults_[number];
  SimulatedBus& bus = world_->bus(bus_);
  const NodeId id = node_of(fault);
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
      return trouble_.disturb(present ? corrupted_share : 0);
    case FaultKind::lost_frames:
      return devices_->node(id).port().lose(Probability(present ? lost_share : 0));
    case FaultKind::delayed_frames:
      return devices_->node(id).port().delay(present ? frame_delay : Duration{});
    case FaultKind::stuck_axis:
      panel_->jam(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::broken_wire:
      panel_->break_wire(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::drifting_axis:
      panel_->drift(axis_of(fault), present);
      return devices_->hands_moved();
    case FaultKind::vanished_armrest:
      return cuts_.set_power(armrest_id, !present);
    case FaultKind::emergency_stop:
      panel_->press_stop(present);
      return devices_->hands_moved();
    case FaultKind::seat_switch:
      panel_->break_seat_switch(present);
      return devices_->hands_moved();
  }
}

/// Cuts all cables of present faults.
void ExcavatorFaults::cut_cables() {
  SimulatedBus& bus = world_->bus(bus_);
  bus.mend_cable();
  for (const auto& node : devices_->nodes()) {
    const bool is_cut = faults_.is_present(FaultKind::cable_cut, node->place().id);
    if (is_cut) bus.cut_cable(node->controller());
  }
}

}  // namespace canvoy::excavator
