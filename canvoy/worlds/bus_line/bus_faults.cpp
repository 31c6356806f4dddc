#include "canvoy/worlds/bus_line/bus_faults.hpp"

#include "canvoy/worlds/bus_line/excused_kinds.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::size_t second_door = 1;

}  // namespace

BusFaults::BusFaults(BusNodes& nodes, const FaultPlan& plan, const Parts& parts, const Hands& hands,
                     EventLog<NetworkEvent>& events)
    : nodes_(nodes),
      parts_(parts),
      hands_(hands),
      events_(events),
      faults_(plan.faults, Engine::of(*this)),
      cuts_(PowerCuts::Switch::to<&BusFaults::power>(*this)) {
  for (unsigned car = 1; car <= nodes.cars(); ++car) troubles_.emplace_back(nodes.cable(car));
}

void BusFaults::plan() {
  if (faults_.has_any(FaultKind::babbling_node)) troubles_[0].attach_babbler();
  faults_.plan(nodes_.world());
}

/// Device of a fault by its node-ID, or the usual one of its kind; 0: it is at none.
DeviceKey BusFaults::device_of(const ScheduledFault& fault) const {
  const bool has_own = has_node(fault.kind) && fault.node != 0;
  return has_own ? key_of(nodes_.design(), fault.node) : node_of(fault);
}

FaultPlace BusFaults::place_of(const ScheduledFault& fault) const {
  const DeviceKey key = device_of(fault);
  return {.bus = nodes_.index_of(key), .node = nodes_.id(key)};
}

void BusFaults::began(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultBegan{fault, it.kind, place_of(it)});
  const InvariantSet kinds = affected_by(it.kind, device_of(it));
  parts_.referee.fault_begins(kinds, now());
  hands_.began(kinds);
  if (!lasts(it.kind)) parts_.referee.fault_ends(kinds, now());
}

void BusFaults::ended(std::size_t fault) {
  const ScheduledFault& it = faults_[fault];
  events_.note(now(), FaultEnded{fault, it.kind, place_of(it)});
  if (lasts(it.kind)) parts_.referee.fault_ends(affected_by(it.kind, device_of(it)), now());
}

void BusFaults::set(std::size_t number, bool is_present) {
  const ScheduledFault& fault = faults_[number];
  switch (fault.kind) {
    case FaultKind::lost_node:
      return cuts_.set_power(device_of(fault), !is_present);
    case FaultKind::restart:
      return is_present ? cuts_.restart(device_of(fault)) : void();
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
    case FaultKind::corrupted_frames:
    case FaultKind::train_bus_cut:
      return set_of_cables(fault, is_present);
    case FaultKind::broken_door:
      parts_.vehicle.break_door(now(), second_door, is_present);
      return hands_.vehicle_touched();
    case FaultKind::blocked_door:
      parts_.vehicle.obstruct_door(now(), second_door, is_present);
      return hands_.vehicle_touched();
    case FaultKind::wrong_clock:
      return parts_.computer.mistake_clock(is_present);
    case FaultKind::no_satellites:
      return parts_.sensors.lose_satellites(is_present);
    case FaultKind::no_paper:
      return parts_.tickets.take_paper(is_present);
  }
}

void BusFaults::cut(DeviceKey behind, bool is_present) {
  troubles_.at(nodes_.car_of(behind) - 1U).cut_cable(nodes_.node(behind).controller(), is_present);
}

void BusFaults::set_of_cables(const ScheduledFault& fault, bool is_present) {
  BusTrouble& first = troubles_[0];
  switch (fault.kind) {
    case FaultKind::cable_cut:
      return cut(device_of(fault), is_present);
    case FaultKind::babbling_node:
      return first.babble(is_present);
    case FaultKind::corrupted_frames:
      for (BusTrouble& trouble : troubles_) {
        trouble.disturb(is_present ? corrupted_share : 0);
      }
      return;
    default:
      return parts_.following.cut_train_bus(is_present);
  }
}

void BusFaults::power(DeviceKey key, bool is_on) {
  if (!is_on) parts_.displays.lose_power(key);
  nodes_.node(key).power(is_on);
}

}  // namespace canvoy::bus_line
