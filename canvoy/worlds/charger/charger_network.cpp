#include "canvoy/worlds/charger/charger_network.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/random.hpp"
#include "canvoy/profiles/cia419.hpp"

namespace canvoy::charger {

namespace {

ChargerOptions with_meter_of_seed(ChargerOptions options) {
  Random random(options.faults.seed);
  const double share = static_cast<double>(random.below(2001)) / 1000 - 1;  // from -1 to 1
  options.stage.meter_gain *= 1 + share * options.meter_tolerance;
  return options;
}

}  // namespace

ChargerNetwork::ChargerNetwork() : ChargerNetwork(ChargerOptions()) {}

ChargerNetwork::ChargerNetwork(const ChargerOptions& options)
    : options_(with_meter_of_seed(options)),
      devices_(world_, options_),
      referees_(options_, devices_, events_),
      bus_watch_(devices_.bus(), [this](Time now, const BusEvent& event) { heard(now, event); }),
      connections_(events_),
      stepping_(world_.add_plant(Callback<void(Time)>::to<&ChargerNetwork::step>(*this),
                                 ChargingPlant::step_time)),
      faults_(world_, options_, devices_, referees_, events_) {
  observe_bus();
  charger().charger().on_event(
      Callback<void(cia419::Charger::Event)>::to<&ChargerNetwork::charger_said>(*this));
  devices_.on_set_point(Callback<void(double)>::to<&ChargerReferees::set_point>(referees_));
  devices_.on_connections(Callback<void(Time)>::to<&ChargerNetwork::connections_changed>(*this));
  devices_.start();
}

void ChargerNetwork::observe_bus() {
  world_.bus().observe(
      {.context = this,
       .on_frame = [](void* self, Time now, ControllerId,
                      const Frame& frame) { static_cast<ChargerNetwork*>(self)->hear(now, frame); },
       .on_state = nullptr});
  bus_watch_.name(charger_controller(), options_.charger_id);
  bus_watch_.name(battery_controller(), options_.battery_id);
  world_.bus().observe(bus_watch_.tap());
}

void ChargerNetwork::step(Time now) {
  plant().step();
  referees_.step(now);
}

void ChargerNetwork::connections_changed(Time now) {
  connections_.look(now, devices_.connections());
}

void ChargerNetwork::hear(Time now, const Frame& frame) {
  referees_.hear(now, frame);
  const bool is_time = frame.is_plain() && frame.id == can_id::time;
  if (is_time && frame.length == time_of_day_bytes) hear_time(now, frame);
}

void ChargerNetwork::hear_time(Time now, const Frame& frame) {
  if (std::exchange(time_seen_, true)) return;
  note(now, TimeSeen{decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>())});
}

/// Events of the vehicle's manager are ignored.
void ChargerNetwork::heard(Time now, const BusEvent& event) {
  std::visit(
      [&]<class Seen>(const Seen& seen) {
        const bool is_command = std::is_same_v<Seen, NmtCommandSeen>;
        const bool is_of_story =
            seen.node == options_.charger_id || seen.node == options_.battery_id;
        if (is_command || is_of_story) note(now, seen);
      },
      event);
}

void ChargerNetwork::charger_said(cia419::Charger::Event event) {
  const cia419::Charger& charger = devices_.charger().charger();
  const Time at = devices_.charger().node().now();
  switch (event) {
    case cia419::Charger::Event::phase_changed:
      return note(at, PhaseEntered{charger.phase(), charger.battery()});
    case cia419::Charger::Event::reason_changed:
      referees_.reason_changed(at);
      return note(at, ReasonChanged{charger.reason()});
    case cia419::Charger::Event::charge_began:
      return note(at, ChargeBegan{});
    case cia419::Charger::Event::charge_ended:
      return note(at, ChargeEnded{charger.ampere_hours_total()});
  }
}

ChargerSnapshot ChargerNetwork::snapshot() {
  const BusIndex on = devices_.bus();
  const SimulatedBus& bus = world_.bus(on);
  const ChargingPlant& truth = plant();
  const cia419::Charger& control = charger().charger();
  const Values charger_values(charger().node().dictionary());
  return {.at = now(),
          .bus = {bus.load(charger_controller()), bus.statistics().frames,
                  bus.statistics().error_frames},
          .charger = played_snapshot(world_, on, devices_.charger_slot(), charger().node()),
          .battery = played_snapshot(world_, on, devices_.battery_slot(), battery().node()),
          .phase = control.phase(),
          .reason = control.reason(),
          .charger_is_ready = charger_values[cia419::charger_status].is(Readiness::ready),
          .set_point_ampere = control.set_point_ampere(),
          .measured_ampere = truth.stage.measured_ampere(),
          .counted_ampere_hours = control.ampere_hours_total(),
          .counted_watt_hours = control.energy_total_watt_hours(),
          .readings = battery().unit().readings(),
          .ampere = truth.ampere(),
          .volt = truth.battery.terminal_volt(),
          .celsius = truth.battery.celsius(),
          .state_of_charge = truth.battery.state_of_charge(),
          .ampere_hours = truth.ampere_hours(),
          .watt_hours = truth.energy_watt_hour()};
}

bool ChargerNetwork::all_hold() const {
  const std::vector<Invariant> all = invariants();
  return std::all_of(all.begin(), all.end(),
                     [](const Invariant& invariant) { return invariant.held; });
}

}  // namespace canvoy::charger
