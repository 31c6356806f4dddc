// Making the faults of the plan, and mending them.
#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/sim/police/police_network.hpp"

namespace canvoy::police {

namespace {

/// An NMT command of the wrong length: nobody obeys it, and nothing has a higher priority.
constexpr Frame police_babble{.id = can_id::nmt, .length = Frame::length_max};

NodeId place_of_fault(const ScheduledFault& fault) {
  if (!has_node(fault.kind)) return 0;
  return fault.node == 0 ? terminal_id : fault.node;
}

}  // namespace

void PoliceNetwork::plan_faults() {
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

void PoliceNetwork::begin(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  note(now(), FaultBegan{fault, it.kind, {.bus = bus_, .node = place_of_fault(it)}});
  if (lasts(it.kind) && !is_harmless(it.kind)) ++faults_present_;
  excused_until_ = std::max(excused_until_, now() + excuse_of(it.kind));
  if (++present_.at(static_cast<std::size_t>(it.kind)) == 1 || has_node(it.kind)) {
    set_fault(it, true);
  }
}

void PoliceNetwork::end(std::size_t fault) {
  const ScheduledFault& it = options_.faults.faults[fault];
  note(now(), FaultEnded{fault, it.kind, {.bus = bus_, .node = place_of_fault(it)}});
  if (lasts(it.kind) && !is_harmless(it.kind)) --faults_present_;
  excused_until_ = std::max(excused_until_, now() + excuse_of(it.kind));
  // Another one of the same kind may last longer.
  if (--present_.at(static_cast<std::size_t>(it.kind)) == 0 || has_node(it.kind)) {
    set_fault(it, false);
  }
}

void PoliceNetwork::set_fault(const ScheduledFault& fault, bool present) {
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
      return present ? bus.cut_cable(nodes_.front()->controller()) : bus.mend_cable();
    case FaultKind::babbling_node:
      bus.power(babbler_, present);
      return present ? bus.babble(babbler_, police_babble) : bus.stop_babbling(babbler_);
    case FaultKind::corrupted_frames:
      return bus.set_frame_error_probability(present ? options_.faults.corrupted_share : 0);
    case FaultKind::burnt_lamp:
      return burn_lamp(present);
    case FaultKind::overload:
      if (!has_power(power_supply_id)) return;
      supply_->report_overload(cia447::Supply::radio, present);
      return touched(power_supply_id);
    case FaultKind::dead_client:
      client_shall_die_ = present;
      if (!present && dead_client_ != 0) set_power(std::exchange(dead_client_, 0), true);
      return;
  }
}

/// Two faults may keep a device from its power; it has it again when both are over.
void PoliceNetwork::set_power(NodeId id, bool is_on) {
  unsigned& without = without_power_.at(id);
  if (is_on ? --without == 0 : ++without == 1) power(node(id), is_on);
}

/// The module notices that no current flows.
void PoliceNetwork::burn_lamp(bool is_burnt) {
  constexpr auto status = cia447::place_of(cia447::blue_light_flasher_status_front_left);
  around_.flashers.burn_out(status.first_bit / 2U, is_burnt);
  if (!has_power(blue_light_id)) return;
  blue_light_->switching().sense(status,
                                 is_burnt ? cia447::Sensing::failure : cia447::Sensing::working);
  touched(blue_light_id);
}

void PoliceNetwork::look_for_client() {
  const std::optional<Client> client = shown_client();
  if (!client_shall_die_ || !client) return;
  constexpr std::array<NodeId, client_count> nodes = {radio_id, roof_sound_id, navigation_id};
  client_shall_die_ = false;
  dead_client_ = nodes.at(static_cast<std::size_t>(*client));
  set_power(dead_client_, false);
}

}  // namespace canvoy::police
