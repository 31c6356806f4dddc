#include "canvoy/worlds/charger/charging_bay.hpp"

#include <utility>

#include "canvoy/profiles/cia419.hpp"

namespace canvoy::charger {

ChargingBay::ChargingBay(World& world, const ChargerOptions& options, BusIndex bus)
    : world_(world),
      options_(with_drawn_meter(options)),
      devices_(world, options_, bus),
      referees_(options_, devices_, events_),
      connections_(events_),
      stepping_(world.add_plant(Callback<void(Time)>::to<&ChargingBay::step>(*this),
                                ChargingPlant::step_time)),
      faults_(world, options_, devices_, referees_, events_) {
  devices_.charger().charger().on_event(
      Callback<void(cia419::Charger::Event)>::to<&ChargingBay::charger_said>(*this));
  devices_.on_set_point(Callback<void(double)>::to<&ChargerReferees::set_point>(referees_));
  devices_.on_connections(Callback<void(Time)>::to<&ChargingBay::connections_changed>(*this));
}

void ChargingBay::step(Time now) {
  devices_.plant().step();
  referees_.step(now);
}

void ChargingBay::connections_changed(Time now) {
  connections_.look(now, devices_.connections());
}

void ChargingBay::hear(Time now, const Frame& frame) {
  referees_.hear(now, frame);
  const bool is_time = frame.is_plain() && frame.id == can_id::time;
  if (is_time && frame.length == time_of_day_bytes) hear_time(now, frame);
}

void ChargingBay::hear_time(Time now, const Frame& frame) {
  if (std::exchange(time_seen_, true)) return;
  note(now, TimeSeen{decode_time<TimeOfDay>(std::span(frame.data).first<time_of_day_bytes>())});
}

/// Events of the vehicle's manager are ignored.
void ChargingBay::heard(Time now, const BusEvent& event) {
  std::visit(
      [&]<class Seen>(const Seen& seen) {
        const bool is_command = std::is_same_v<Seen, NmtCommandSeen>;
        const bool is_of_story =
            seen.node == options_.charger_id || seen.node == options_.battery_id;
        if (is_command || is_of_story) note(now, seen);
      },
      event);
}

void ChargingBay::charger_said(cia419::Charger::Event event) {
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

ChargerSnapshot ChargingBay::snapshot() {
  const BusIndex on = devices_.bus();
  const SimulatedBus& bus = world_.bus(on);
  const ChargingPlant& truth = devices_.plant();
  const cia419::Charger& control = devices_.charger().charger();
  const Values charger_values(devices_.charger().node().dictionary());
  return {
      .at = world_.now(),
      .bus = {bus.load(devices_.charger_controller()), bus.statistics().frames,
              bus.statistics().error_frames},
      .charger = played_snapshot(world_, on, devices_.charger_slot(), devices_.charger().node()),
      .battery = played_snapshot(world_, on, devices_.battery_slot(), devices_.battery().node()),
      .phase = control.phase(),
      .reason = control.reason(),
      .charger_is_ready = charger_values[cia419::charger_status].is(Readiness::ready),
      .set_point_ampere = control.set_point_ampere(),
      .measured_ampere = truth.stage.measured_ampere(),
      .counted_ampere_hours = control.ampere_hours_total(),
      .counted_watt_hours = control.energy_total_watt_hours(),
      .readings = devices_.battery().unit().readings(),
      .ampere = truth.ampere(),
      .volt = truth.battery.terminal_volt(),
      .celsius = truth.battery.celsius(),
      .state_of_charge = truth.battery.state_of_charge(),
      .ampere_hours = truth.ampere_hours(),
      .watt_hours = truth.energy_watt_hour()};
}

}  // namespace canvoy::charger
