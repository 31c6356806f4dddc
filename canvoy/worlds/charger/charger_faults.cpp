#include "canvoy/worlds/charger/charger_faults.hpp"

#include "canvoy/worlds/charger/imposter.hpp"

namespace canvoy::charger {

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

}  // namespace canvoy::charger
