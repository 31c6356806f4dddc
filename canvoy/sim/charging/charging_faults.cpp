// Making the faults of the plan, and mending them.
#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/sim/charging/imposter.hpp"

namespace canvoy::charging {

namespace {

/// An NMT command of the wrong length: nobody obeys it, and nothing has a higher priority.
constexpr Frame babble{.id = can_id::nmt, .length = Frame::length_max};

}  // namespace

ChargingNetwork::~ChargingNetwork() = default;

void ChargingNetwork::plan_faults() {
  for (std::size_t i = 0; i < options_.faults.faults.size(); ++i) {
    const ScheduledFault& fault = options_.faults.faults[i];
    prepare(fault.kind);
    world_.at(fault.start, [this, i](Time) { begin(i); });
    if (fault.end() != never) world_.at(fault.end(), [this, i](Time) { end(i); });
  }
}

/// Third nodes are on the cable from the start, without power.
void ChargingNetwork::prepare(FaultKind kind) {
  if (kind == FaultKind::duplicate_node_id && imposter_ == nullptr) {
    imposter_ = std::make_unique<Imposter>(world_, bus_, options_.battery_id,
                                           plant_.battery.hardware(), battery_settings());
  }
  if (kind == FaultKind::babbling_node && babbler_ == no_controller) {
    babbler_ = world_.bus(bus_).attach({});
    world_.bus(bus_).power(babbler_, false);
  }
}

void ChargingNetwork::begin(std::size_t fault) {
  const FaultKind kind = options_.faults.faults[fault].kind;
  note(now(), FaultBegan{fault, kind});
  ++present_.at(static_cast<std::size_t>(kind));
  set_fault(kind, true);
  service_.fault_began(now(), kind);
  fault_watch_.began(fault, now(), charger_.charger().reason());
}

void ChargingNetwork::end(std::size_t fault) {
  const FaultKind kind = options_.faults.faults[fault].kind;
  note(now(), FaultEnded{fault, kind});
  // Another one of the same kind may last longer.
  if (--present_.at(static_cast<std::size_t>(kind)) == 0) set_fault(kind, false);
  fault_watch_.note(now(), charger_.charger().reason());
  fault_watch_.ended(fault);
  service_.fault_ended(now(), kind);
}

void ChargingNetwork::set_fault(FaultKind kind, bool present) {
  SimulatedBus& bus = world_.bus(bus_);
  switch (kind) {
    case FaultKind::heartbeat_loss:
      return battery_port_.lose(can_id::error_control + std::uint32_t{options_.battery_id},
                                present);
    case FaultKind::pdo_loss:
      for (const std::uint32_t id : rules().battery_tpdos) battery_port_.lose(id, present);
      return;
    case FaultKind::battery_silent:
      return set_battery_running(!present);
    case FaultKind::battery_restart:
      return present && !is_present(FaultKind::battery_silent) ? set_battery_running(true) : void();
    case FaultKind::cable_cut:
      return present ? bus.cut_cable(charger_controller()) : bus.mend_cable();
    case FaultKind::corrupted_frames:
      return bus.set_frame_error_probability(present ? options_.faults.corrupted_share : 0);
    case FaultKind::babbling_node:
      bus.power(babbler_, present);
      return present ? bus.babble(babbler_, babble) : bus.stop_babbling(babbler_);
    case FaultKind::duplicate_node_id:
      return present ? world_.start(imposter_->slot) : world_.stop(imposter_->slot);
    case FaultKind::wrong_bit_rate:
      return bus.set_bit_rate(battery_controller(),
                              present ? options_.faults.wrong_bit_rate : options_.bit_rate);
    case FaultKind::clock_drift:
      return world_.set_clock_drift(battery_slot_, present ? options_.faults.clock_drift_ppm : 0);
    default:
      return set_plant_fault(kind, present);
  }
}

void ChargingNetwork::set_plant_fault(FaultKind kind, bool present) {
  BatteryFaults& battery = plant_.battery.faults;
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
      plant_.stage.faults.pilot_signal_is_lost = present;
      return;
    default:
      return;
  }
}

/// One sensor shows both: the fault that came last, as long as it lasts.
void ChargingNetwork::show_temperature(FaultKind last) {
  const FaultKind other = last == FaultKind::too_hot ? FaultKind::too_cold : FaultKind::too_hot;
  const FaultKind kind = is_present(last) ? last : other;
  std::optional<double>& shown = plant_.battery.faults.shown_celsius;
  shown.reset();
  if (!is_present(kind)) return;
  shown = kind == FaultKind::too_hot ? options_.faults.hot_celsius : options_.faults.cold_celsius;
}

void ChargingNetwork::set_battery_running(bool runs) {
  runs ? world_.start(battery_slot_) : world_.stop(battery_slot_);
}

}  // namespace canvoy::charging
