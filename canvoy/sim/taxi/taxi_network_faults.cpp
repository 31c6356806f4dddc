// Making the faults of the plan, and mending them.
#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

namespace {

/// An NMT command of the wrong length: nobody obeys it, and nothing has a higher priority.
constexpr Frame babble{.id = can_id::nmt, .length = Frame::length_max};

NodeId node_of(const ScheduledFault& fault) {
  return fault.node == 0 ? taximeter_id : fault.node;
}

}  // namespace

void TaxiNetwork::plan_faults() {
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

void TaxiNetwork::begin(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  note(now(),
       FaultBegan{
           fault, it.kind, {.bus = bus_, .node = has_node(it.kind) ? node_of(it) : NodeId{0}}});
  if (lasts(it.kind) && !is_local(it.kind)) ++faults_present_;
  excuse(it.kind);
  if (++present_.at(static_cast<std::size_t>(it.kind)) == 1 || has_node(it.kind)) {
    set_fault(it, true);
  }
}

void TaxiNetwork::end(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  note(now(),
       FaultEnded{
           fault, it.kind, {.bus = bus_, .node = has_node(it.kind) ? node_of(it) : NodeId{0}}});
  if (lasts(it.kind) && !is_local(it.kind)) --faults_present_;
  excuse(it.kind);
  // Another one of the same kind may last longer.
  if (--present_.at(static_cast<std::size_t>(it.kind)) == 0 || has_node(it.kind)) {
    set_fault(it, false);
  }
}

/// What has just begun or ended may cost a trip, and others the time to come back.
void TaxiNetwork::excuse(FaultKind kind) {
  if (is_local(kind)) return;
  fares_.disturb();
  excused_until_ = std::max(excused_until_, now() + return_bound);
}

void TaxiNetwork::set_fault(const ScheduledFault& fault, bool present) {
  SimulatedBus& bus = world_.bus(bus_);
  switch (fault.kind) {
    case FaultKind::lost_node:
      return set_power(node_of(fault), !present);
    case FaultKind::restart:
      if (present && without_power_.at(node_of(fault)) == 0) {
        power(node(node_of(fault)), false);
        power(node(node_of(fault)), true);
      }
      return;
    case FaultKind::cable_cut:
      return present ? bus.cut_cable(nodes_.front()->controller()) : bus.mend_cable();
    case FaultKind::babbling_node:
      bus.power(babbler_, present);
      return present ? bus.babble(babbler_, babble) : bus.stop_babbling(babbler_);
    case FaultKind::corrupted_frames:
      return bus.set_frame_error_probability(present ? options_.faults.corrupted_share : 0);
    case FaultKind::wheel_signal:
      wheel_is_lost_ = present;
      return;
    case FaultKind::paper_out:
      return take_paper(present);
    case FaultKind::no_fix:
      fix_is_lost_ = present;
      return;
  }
}

/// Two faults may keep a device from its power; it has it again when both are over.
void TaxiNetwork::set_power(NodeId id, bool is_on) {
  unsigned& without = without_power_.at(id);
  if (is_on ? --without == 0 : ++without == 1) power(node(id), is_on);
}

/// A line that was begun stays on the old roll.
void TaxiNetwork::take_paper(bool is_out) {
  paper_is_out_ = is_out;
  if (!is_out) paper_.new_roll();
  if (node(printer_id).is_powered()) printer_->sense_paper(!is_out);
  world_.touched(printer_id - SlotIndex{1});
}

/// A printer that starts looks whether it has paper.
void TaxiNetwork::is_printer(cia447::PrinterUnit& unit, Node& /*node*/) {
  printer_ = &unit;
  unit.sense_paper(!paper_is_out_);
}

}  // namespace canvoy::taxi
