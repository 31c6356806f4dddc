#include "canvoy/worlds/charger/charging_bay.hpp"

#include <utility>

#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::charger {

// A second battery module at the same battery, with the node-ID of the first: a spare part that was
// put in without removing the old one.

/// On the cable from the start, without power until World::start(slot).
struct Imposter {
  /// Puts it on the bus.
  Imposter(World& world, BusIndex bus, NodeId id, const cia418::BatteryHardware& hardware,
           const cia418::BatterySettings& settings)
      : slot(world.add_slot(bus)), device(world.port(slot), id, hardware, settings) {
    world.occupy(slot, device.node());
  }

  SlotIndex slot;                  ///< on the bus
  cia418::BatteryDevice<> device;  ///< the module
};

namespace {

// Extent of the faults of the battery, as in the rows of the kinds.
constexpr std::int32_t clock_drift_ppm = 5000;
constexpr double hot_celsius = 55;  ///< reading of its sensor
constexpr double cold_celsius = -12;
constexpr std::uint32_t wrong_bit_rate = 250'000;

}  // namespace

ChargerFaults::ChargerFaults(World& world, const ChargerOptions& options, ChargerDevices& devices,
                             ChargerReferees& referees, std::vector<ChargerEvent>& events)
    : world_(&world),
      options_(&options),
      devices_(&devices),
      referees_(&referees),
      events_(&events),
      trouble_(world.bus(devices.bus())),
      faults_(options.faults.faults, Engine::of(*this), FaultMaking::each) {
  for (const ScheduledFault& fault : options.faults.faults) prepare(fault.kind);
  faults_.plan(world);
}

ChargerFaults::~ChargerFaults() = default;

/// Further nodes are on the cable from the start, without power.
void ChargerFaults::prepare(FaultKind kind) {
  if (kind == FaultKind::duplicate_node_id && imposter_ == nullptr) {
    imposter_ = std::make_unique<Imposter>(*world_, devices_->bus(), options_->battery_id,
                                           devices_->plant().battery.hardware(),
                                           devices_->battery_settings());
  }
  if (kind == FaultKind::babbling_node) trouble_.attach_babbler();
}

void ChargerFaults::began(std::size_t fault) {
  events_->push_back({world_->now(), FaultBegan{fault, faults_[fault].kind}});
  referees_->fault_began(world_->now(), fault);
}

void ChargerFaults::ended(std::size_t fault) {
  events_->push_back({world_->now(), FaultEnded{fault, faults_[fault].kind}});
  referees_->fault_ended(world_->now(), fault);
}

void ChargerFaults::set(std::size_t fault, bool present) {
  const FaultKind kind = faults_[fault].kind;
  switch (kind) {
    case FaultKind::heartbeat_loss:
      return devices_->battery_port().lose(
          can_id::error_control + std::uint32_t{options_->battery_id}, present);
    case FaultKind::pdo_loss:
      for (const std::uint32_t id : devices_->rules().battery_tpdos)
        devices_->battery_port().lose(id, present);
      return;
    case FaultKind::battery_silent:
      return devices_->power_battery(!present);
    case FaultKind::battery_restart:
      return present && !faults_.is_present(FaultKind::battery_silent)
                 ? devices_->power_battery(true)
                 : void();
    case FaultKind::cable_cut:
      return trouble_.cut_cable(devices_->charger_controller(), present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(present ? corrupted_share : 0);
    case FaultKind::babbling_node:
      return trouble_.babble(present);
    case FaultKind::duplicate_node_id:
      return present ? world_->start(imposter_->slot) : world_->stop(imposter_->slot);
    case FaultKind::wrong_bit_rate:
      return world_->bus(devices_->bus())
          .set_bit_rate(devices_->battery_controller(),
                        present ? wrong_bit_rate : options_->bit_rate);
    case FaultKind::clock_drift:
      return world_->set_clock_drift(devices_->battery_slot(), present ? clock_drift_ppm : 0);
    default:
      return set_in_plant(kind, present);
  }
}

void ChargerFaults::set_in_plant(FaultKind kind, bool present) {
  BatteryFaults& battery = devices_->plant().battery.faults;
  switch (kind) {
    case FaultKind::not_ready:
      battery.is_not_ready = present;
      return;
    case FaultKind::too_hot:
    case FaultKind::too_cold:
      return show_temperature(kind);
    case FaultKind::invalid_temperature:
      battery.temperature_is_invalid = present;
      return;
    case FaultKind::invalid_voltage:
      battery.voltage_is_invalid = present;
      return;
    case FaultKind::pilot_loss:
      devices_->plant().stage.faults.pilot_signal_is_lost = present;
      return;
    default:
      return;
  }
}

/// One sensor shows both faults: the last one counts, as long as it lasts.
void ChargerFaults::show_temperature(FaultKind last) {
  const FaultKind other = last == FaultKind::too_hot ? FaultKind::too_cold : FaultKind::too_hot;
  const FaultKind kind = faults_.is_present(last) ? last : other;
  std::optional<double>& shown = devices_->plant().battery.faults.shown_celsius;
  shown.reset();
  if (!faults_.is_present(kind)) return;
  shown = kind == FaultKind::too_hot ? hot_celsius : cold_celsius;
}

ChargingBay::ChargingBay(World& world, const ChargerOptions& options, BusIndex bus)
    : world_(world),
      options_(with_drawn_meter(options)),
      devices_(world, options_, bus),
      referees_(options_, devices_, events_),
      connections_(events_),
      stepping_(world.add_plant(callback<&ChargingBay::step>(*this), ChargingPlant::step_time)),
      faults_(world, options_, devices_, referees_, events_) {
  devices_.charger().charger().on_event(callback<&ChargingBay::charger_said>(*this));
  devices_.on_set_point(callback<&ChargerReferees::set_point>(referees_));
  devices_.on_connections(callback<&ChargingBay::connections_changed>(*this));
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
