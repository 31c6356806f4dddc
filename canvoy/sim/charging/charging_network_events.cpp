// What happens on the bus, in the charger and in the plant: noted, and judged.
#include <utility>

#include "canvoy/sim/charging/charging_network.hpp"

namespace canvoy::charging {

void ChargingNetwork::step(Time now) {
  plant_.step();
  handshake_.on_step(now, plant_.stage.pilot_signal(), plant_.ampere());
  fault_watch_.note(now, charger_.charger().reason());
  service_.on_step(now, battery_asks(), plant_.ampere());
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
  const bool is_time = frame.is_plain() && frame.id == can_id::time;
  if (is_time && frame.length == time_of_day_bytes) hear_time(now, frame);
}

void ChargingNetwork::hear_time(Time now, const Frame& frame) {
  if (std::exchange(time_seen_, true)) return;
  note(now, TimeSeen{decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>())});
}

/// The manager of the vehicle does not belong to the story.
void ChargingNetwork::heard(Time now, const BusEvent& event) {
  std::visit(
      [&]<class Seen>(const Seen& seen) {
        const bool is_command = std::is_same_v<Seen, NmtCommandSeen>;
        const bool is_of_story =
            seen.node == options_.charger_id || seen.node == options_.battery_id;
        if (is_command || is_of_story) note(now, seen);
      },
      event);
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
