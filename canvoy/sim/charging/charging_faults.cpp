#include "canvoy/sim/charging/charging_faults.hpp"

#include "canvoy/sim/charging/imposter.hpp"

namespace canvoy::charging {

ChargingFaults::ChargingFaults(World& world, const ChargingOptions& options,
                               ChargingDevices& devices, ChargingReferees& referees,
                               std::vector<ChargingEvent>& events)
    : world_(&world),
      options_(&options),
      devices_(&devices),
      referees_(&referees),
      events_(&events),
      trouble_(world.bus(devices.bus())) {
  for (std::size_t i = 0; i < options.faults.faults.size(); ++i) {
    const ScheduledFault& fault = options.faults.faults[i];
    prepare(fault.kind);
    world.at(fault.start, [this, i](Time) { begin(i); });
    if (fault.end() != never) world.at(fault.end(), [this, i](Time) { end(i); });
  }
}

ChargingFaults::~ChargingFaults() = default;

/// Third nodes are on the cable from the start, without power.
void ChargingFaults::prepare(FaultKind kind) {
  if (kind == FaultKind::duplicate_node_id && imposter_ == nullptr) {
    imposter_ = std::make_unique<Imposter>(*world_, devices_->bus(), options_->battery_id,
                                           devices_->plant().battery.hardware(),
                                           devices_->battery_settings());
  }
  if (kind == FaultKind::babbling_node) trouble_.attach_babbler();
}

void ChargingFaults::begin(std::size_t fault) {
  const FaultKind kind = options_->faults.faults[fault].kind;
  const Time now = world_->now();
  events_->push_back({now, FaultBegan{fault, kind}});
  ++present_.at(static_cast<std::size_t>(kind));
  set(kind, true);
  referees_->fault_began(now, fault);
}

void ChargingFaults::end(std::size_t fault) {
  const FaultKind kind = options_->faults.faults[fault].kind;
  const Time now = world_->now();
  events_->push_back({now, FaultEnded{fault, kind}});
  // Another one of the same kind may last longer.
  if (--present_.at(static_cast<std::size_t>(kind)) == 0) set(kind, false);
  referees_->fault_ended(now, fault);
}

void ChargingFaults::set(FaultKind kind, bool present) {
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
      return present && !is_present(FaultKind::battery_silent) ? devices_->power_battery(true)
                                                               : void();
    case FaultKind::cable_cut:
      return trouble_.cut_cable(devices_->charger_controller(), present);
    case FaultKind::corrupted_frames:
      return trouble_.disturb(present ? options_->faults.corrupted_share : 0);
    case FaultKind::babbling_node:
      return trouble_.babble(present);
    case FaultKind::duplicate_node_id:
      return present ? world_->start(imposter_->slot) : world_->stop(imposter_->slot);
    case FaultKind::wrong_bit_rate:
      return world_->bus(devices_->bus())
          .set_bit_rate(devices_->battery_controller(),
                        present ? options_->faults.wrong_bit_rate : options_->bit_rate);
    case FaultKind::clock_drift:
      return world_->set_clock_drift(devices_->battery_slot(),
                                     present ? options_->faults.clock_drift_ppm : 0);
    default:
      return set_in_plant(kind, present);
  }
}

void ChargingFaults::set_in_plant(FaultKind kind, bool present) {
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

/// One sensor shows both: the fault that came last, as long as it lasts.
void ChargingFaults::show_temperature(FaultKind last) {
  const FaultKind other = last == FaultKind::too_hot ? FaultKind::too_cold : FaultKind::too_hot;
  const FaultKind kind = is_present(last) ? last : other;
  std::optional<double>& shown = devices_->plant().battery.faults.shown_celsius;
  shown.reset();
  if (!is_present(kind)) return;
  shown = kind == FaultKind::too_hot ? options_->faults.hot_celsius : options_->faults.cold_celsius;
}

}  // namespace canvoy::charging
