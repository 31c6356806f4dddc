// Making the faults of the plan, and mending them; and what they excuse.
#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus {

namespace {

using Kind = InvariantKind;

/// An NMT command of the wrong length: nobody obeys it, and nothing has a higher priority.
constexpr Frame bus_babble{.id = can_id::nmt, .length = Frame::length_max};
constexpr std::size_t second_door = 1;

NodeId place_of_fault(const ScheduledFault& fault) {
  if (!has_node(fault.kind)) return 0;
  if (fault.node != 0) return fault.node;
  return fault.kind == FaultKind::restart ? computer_id : next_stop_id;
}

InvariantSet set_of(std::initializer_list<Kind> kinds) {
  InvariantSet set;
  for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

/// All but that displays do not lie, and that texts are whole.
InvariantSet all_services() {
  InvariantSet set;
  set.set();
  return set & ~set_of({Kind::lie, Kind::texts});
}

/// What the gateways carry from car to car.
InvariantSet train_services() {
  return set_of({Kind::second_car, Kind::second_announcements, Kind::second_stop_sign});
}

InvariantSet affected_by_loss_of(NodeId node) {
  switch (node) {
    case computer_id:
      return all_services();  // nobody starts the others
    case identification_id:
      return set_of({Kind::next_stop, Kind::destination, Kind::information, Kind::announcements,
                     Kind::tickets, Kind::pdo_tables, Kind::service, Kind::second_car,
                     Kind::second_announcements});
    case front_display_id:
    case side_display_id:
      return set_of({Kind::destination});
    case next_stop_id:
      return set_of({Kind::next_stop, Kind::stop_sign, Kind::second_stop_sign});
    case information_id:
      return set_of({Kind::information});
    case canceller_id:
    case printer_id:
      return set_of({Kind::service});
    case announcer_id:
      return set_of({Kind::announcements});
    case vehicle_gateway_id:
      return set_of(
          {Kind::passengers, Kind::stop_sign, Kind::second_stop_sign, Kind::false_stop_sign});
    case first_counter_id:
    case counting_manager_id:
    case second_counter_id:
      return set_of({Kind::passengers});
    case train_gateway_id:
      return train_services();
    case second_gateway_id:  // nobody starts the others of its segment
      return train_services() | set_of({Kind::device_missing});
    case second_destination_id:
      return set_of({Kind::second_car});
    case second_next_stop_id:
      return set_of({Kind::second_car, Kind::second_stop_sign});
    case second_announcer_id:
      return set_of({Kind::second_announcements});
    default:
      return {};
  }
}

}  // namespace

InvariantSet affected_by(FaultKind kind, NodeId node) {
  switch (kind) {
    case FaultKind::lost_node:
    case FaultKind::restart:
      return affected_by_loss_of(node);
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
      return all_services();
    case FaultKind::broken_door:
    case FaultKind::blocked_door:
    case FaultKind::no_paper:
      return set_of({Kind::service});
    case FaultKind::train_bus_cut:
      return train_services();
    default:
      return {};
  }
}

void BusNetwork::plan_faults() {
  for (std::size_t i = 0; i < options_.faults.faults.size(); ++i) {
    const ScheduledFault& fault = options_.faults.faults[i];
    if (fault.kind == FaultKind::babbling_node && babbler_ == no_controller) {
      babbler_ = world_.bus(bus_).attach({});
      world_.bus(bus_).power(babbler_, false);
    }
    world_.at(fault.start, [this, i](Time) { begin(i); });
    if (fault.end() != never) world_.at(fault.end(), [this, i](Time) { end(i); });
  }
  if (!options_.sabotage.false_messages) return;
  const ControllerId stranger = world_.bus(bus_).attach({});
  world_.at(Time(5min), [this, stranger](Time) {
    world_.bus(bus_).send(stranger, Frame::data_frame(0x201, {1, 2, 3, 4}));
  });
}

void BusNetwork::begin(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  const NodeId id = place_of_fault(it);
  note(now(), FaultBegan{fault, it.kind, {.bus = bus_of(id), .node = id}});
  const InvariantSet kinds = affected_by(it.kind, id);
  referee_.fault_begins(kinds, now());
  if (kinds[static_cast<std::size_t>(Kind::passengers)]) counts_are_lost_ = true;
  // Who knows where the bus is has to learn it anew.
  const bool is_blinded = kinds[static_cast<std::size_t>(Kind::announcements)] &&
                          kinds[static_cast<std::size_t>(Kind::next_stop)];
  needs_fix_ = needs_fix_ || is_blinded;
  if (!lasts(it.kind)) referee_.fault_ends(kinds, now());
  if (++present_.at(static_cast<std::size_t>(it.kind)) == 1 || has_node(it.kind)) {
    set_fault(it, true);
  }
}

void BusNetwork::end(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  const NodeId id = place_of_fault(it);
  note(now(), FaultEnded{fault, it.kind, {.bus = bus_of(id), .node = id}});
  if (lasts(it.kind)) referee_.fault_ends(affected_by(it.kind, id), now());
  // Another one of the same kind may last longer.
  if (--present_.at(static_cast<std::size_t>(it.kind)) == 0 || has_node(it.kind)) {
    set_fault(it, false);
  }
}

void BusNetwork::set_fault(const ScheduledFault& fault, bool present) {
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
    case FaultKind::cable_cut:
      return present ? bus.cut_cable(node(computer_id).controller()) : bus.mend_cable();
    case FaultKind::babbling_node:
      bus.power(babbler_, present);
      return present ? bus.babble(babbler_, bus_babble) : bus.stop_babbling(babbler_);
    case FaultKind::corrupted_frames: {
      const double share = present ? options_.faults.corrupted_share : 0;
      world_.bus(second_bus_).set_frame_error_probability(share);
      return bus.set_frame_error_probability(share);
    }
    case FaultKind::train_bus_cut:
      return train_.cut(present);
    case FaultKind::broken_door:
      vehicle_->break_door(now(), second_door, present);
      return world_.wake(vehicle_plant_, vehicle_->deadline());
    case FaultKind::blocked_door:
      vehicle_->obstruct_door(now(), second_door, present);
      return world_.wake(vehicle_plant_, vehicle_->deadline());
    case FaultKind::wrong_clock:
    case FaultKind::no_satellites:
    case FaultKind::no_paper:
      return;
  }
}

/// Two faults may keep a device from its power; it has it again when both are over.
void BusNetwork::set_power(NodeId id, bool is_on) {
  unsigned& without = without_power_.at(id);
  if (is_on ? --without == 0 : ++without == 1) power(node(id), is_on);
}

}  // namespace canvoy::bus
