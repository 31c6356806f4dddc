// What happens on the bus, in the charger and in the plant: noted, and judged.
#include <algorithm>
#include <utility>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/sim/charging/charging_network.hpp"

namespace canvoy::charging {

void ChargingNetwork::step(Time now) {
  plant_.step();
  handshake_.on_step(now, plant_.stage.pilot_signal(), plant_.ampere());
  fault_watch_.note(now, charger_.charger().reason());
  service_.on_step(now, battery_asks(), plant_.ampere());
  watch_connections(now);
  check(now);
}

/// Where the battery or the charger is a real one, the plant does not know. One that is colder or
/// hotter than the charger bears asks in vain.
bool ChargingNetwork::battery_asks() const {
  const cia418::BatteryReadings& readings = battery_.unit().readings();
  const cia419::ChargeLimits& limits = options_.charger.limits;
  const double celsius = readings.temperature_celsius.value_or(limits.temperature_min_celsius);
  const double margin = limits.temperature_hysteresis_kelvin;
  return options_.plays_battery && options_.plays_charger && plant_.stage.pilot_signal() &&
         readings.ready && readings.requested_current_ampere.value_or(0) > 0 &&
         celsius > limits.temperature_min_celsius + margin &&
         celsius < limits.temperature_max_celsius - margin;
}

/// Given or taken back since the last look.
void ChargingNetwork::watch_connections(Time now) {
  if (!manager_) return;
  const auto is_given = [](const SdoConnection& connection) {
    return connection.state == SdoConnection::State::given;
  };
  const std::span<const SdoConnection> present = manager_->connections();
  for (std::size_t i = 0; i < present.size(); ++i) {
    const SdoConnection& is = present[i];
    SdoConnection& was = connections_.at(i);
    const bool same = is.client == was.client && is.server == was.server;
    if (is_given(was) && !(is_given(is) && same)) {
      note(now, SdoConnectionChanged{was.client, was.server, false});
    }
    if (is_given(is) && !(is_given(was) && same)) {
      note(now, SdoConnectionChanged{is.client, is.server, true});
    }
    was = is;
  }
}

/// Tells of each invariant once that it is broken, when it is.
void ChargingNetwork::check(Time now) {
  const std::array<Invariant, 5> lasting = lasting_invariants();
  for (std::size_t i = 0; i < lasting.size(); ++i) {
    if (lasting.at(i).held || told_.at(i)) continue;
    told_.at(i) = true;
    note(now, InvariantBroken{lasting.at(i)});
  }
  for (const Invariant& broken : fault_watch_.take_broken()) note(now, InvariantBroken{broken});
}

void ChargingNetwork::hear(Time now, const Frame& frame) {
  handshake_.on_frame(now, frame);
  if (!frame.is_plain()) return;
  if (frame.id == can_id::nmt && frame.length == 2) {
    note(now, NmtCommandSeen{bus_, frame.data[1], static_cast<NmtCommand>(frame.data[0])});
  }
  if (frame.id == can_id::time && frame.length == time_of_day_bytes) hear_time(now, frame);
  for (const NodeId node : {options_.charger_id, options_.battery_id}) {
    if (frame.id == can_id::error_control + std::uint32_t{node} && frame.length == 1) {
      hear_error_control(now, node, frame.data[0]);
    }
    if (frame.id == can_id::emergency + std::uint32_t{node} && frame.length == 8) {
      EmergencySeen seen{.bus = bus_,
                         .node = node,
                         .code = load<std::uint16_t>(frame.data.data()),
                         .error_register = frame.data[2]};
      std::copy_n(frame.data.begin() + 3, seen.info.size(), seen.info.begin());
      note(now, seen);
    }
  }
}

void ChargingNetwork::hear_time(Time now, const Frame& frame) {
  if (std::exchange(time_seen_, true)) return;
  note(now, TimeSeen{decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>())});
}

void ChargingNetwork::hear_error_control(Time now, NodeId node, std::uint8_t byte) {
  RemoteState& last = last_states_.at(node == options_.charger_id ? 0 : 1);
  const RemoteState state = remote_state(byte);
  if (state == RemoteState::boot_up) {
    note(now, BootedUp{bus_, node});
  } else if (state != last && state != RemoteState::unknown) {
    note(now, NmtStateSeen{bus_, node, static_cast<NmtState>(state)});
  }
  last = state;
}

void ChargingNetwork::bus_state_changed(Time now, ControllerId controller, BusState state) {
  if (controller == charger_controller())
    note(now, BusStateChanged{bus_, options_.charger_id, state});
  if (controller == battery_controller())
    note(now, BusStateChanged{bus_, options_.battery_id, state});
}

void ChargingNetwork::charger_said(cia419::Charger::Event event) {
  const cia419::Charger& charger = charger_.charger();
  const Time at = charger_.node().now();
  switch (event) {
    case cia419::Charger::Event::phase_changed:
      return note(at, PhaseEntered{charger.phase(), charger.battery()});
    case cia419::Charger::Event::reason_changed:
      fault_watch_.note(at, charger.reason());
      return note(at, ReasonChanged{charger.reason()});
    case cia419::Charger::Event::charge_began:
      return note(at, ChargeBegan{});
    case cia419::Charger::Event::charge_ended:
      return note(at, ChargeEnded{charger.ampere_hours_total()});
  }
}

}  // namespace canvoy::charging
