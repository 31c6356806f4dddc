#include "canvoy/sim/charging/charging_referees.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::charging {

namespace {

/// Enough for a frame to wait for others and be sent again a few times.
constexpr Duration frame_time_max = 50ms;

constexpr double percent = 100;
/// Energy and ampere-hours must agree to this share.
constexpr double count_bound_percent = 1;
/// What went in is taken as so much at least, lest the first seconds decide.
constexpr double ampere_hours_floor = 1;
constexpr double watt_hours_floor = 50;

double error_percent(double counted, double truth, double floor) {
  return std::abs(counted - truth) / std::max(truth, floor) * percent;
}

/// Where nothing was delivered and nothing is counted, nothing is said.
Invariant count_invariant(InvariantKind kind, double counted, double truth, double floor) {
  const double value = error_percent(counted, truth, floor);
  return {.kind = kind,
          .worst = value,
          .allowed = count_bound_percent,
          .held = value <= count_bound_percent,
          .judged = truth > 0 || counted > 0 ? 1U : 0U};
}

Invariant time_invariant(InvariantKind kind, Duration value, Duration bound, std::uint64_t judged) {
  return {.kind = kind,
          .worst = std::chrono::duration<double>(value).count(),
          .allowed = std::chrono::duration<double>(bound).count(),
          .held = value <= bound,
          .judged = judged};
}

}  // namespace

ChargingReferees::ChargingReferees(const ChargingOptions& options, const ChargingDevices& devices,
                                   std::vector<ChargingEvent>& events)
    : options_(&options),
      devices_(&devices),
      events_(&events),
      handshake_(devices.rules()),
      faults_(options.faults, promises()) {}

Promises ChargingReferees::promises() const {
  const HandshakeRules agreed = devices_->rules();
  return {.heartbeat_time = agreed.heartbeat_time,
          .data_time = agreed.data_time,
          .value_time = devices_->battery_settings().sensing_period +
                        agreed.data_time / options_->charger.pdo_periods_max,
          .reaction_time = options_->charger.control_period + frame_time_max};
}

void ChargingReferees::step(Time now) {
  const ChargingPlant& plant = devices_->plant();
  handshake_.on_step(now, plant.stage.pilot_signal(), plant.ampere());
  faults_.note(now, reason());
  service_.on_step(now, battery_asks(), plant.ampere());
  tell_broken(now);
}

/// Where the battery or the charger is a real one, the plant does not know. One that is colder or
/// hotter than the charger bears asks in vain.
bool ChargingReferees::battery_asks() const {
  const cia418::BatteryReadings& readings = devices_->battery().unit().readings();
  const cia419::ChargeLimits& limits = options_->charger.limits;
  const double celsius = readings.temperature_celsius.value_or(limits.temperature_min_celsius);
  const double margin = limits.temperature_hysteresis_kelvin;
  return options_->plays_battery && options_->plays_charger &&
         devices_->plant().stage.pilot_signal() && readings.ready &&
         readings.requested_current_ampere.value_or(0) > 0 &&
         celsius > limits.temperature_min_celsius + margin &&
         celsius < limits.temperature_max_celsius - margin;
}

void ChargingReferees::fault_began(Time now, std::size_t fault) {
  service_.fault_began(now, kind_of(fault));
  faults_.began(fault, now, reason());
}

void ChargingReferees::fault_ended(Time now, std::size_t fault) {
  faults_.note(now, reason());
  faults_.ended(fault);
  service_.fault_ended(now, kind_of(fault));
}

/// Of each invariant once, when it is broken.
void ChargingReferees::tell_broken(Time now) {
  const std::array<Invariant, lasting> now_lasting = lasting_invariants();
  for (std::size_t i = 0; i < lasting; ++i) {
    if (now_lasting.at(i).held || told_.at(i)) continue;
    told_.at(i) = true;
    events_->push_back({now, InvariantBroken{now_lasting.at(i)}});
  }
  for (const Invariant& broken : faults_.take_broken()) {
    events_->push_back({now, InvariantBroken{broken}});
  }
}

/// It may take one period until the charger looks, and as long as the stage needs to fall; the
/// referee sees both in steps of the plant.
Invariant ChargingReferees::handshake() const {
  const Duration bound = options_->charger.control_period +
                         devices_->plant().stage.fall_time_max() + 2 * ChargingPlant::step_time;
  return time_invariant(InvariantKind::current_outside_handshake, handshake_.outside_max(), bound,
                        handshake_.steps_with_current());
}

Invariant ChargingReferees::service() const {
  return time_invariant(InvariantKind::battery_left_waiting, service_.waiting_max(),
                        ServiceWatch::bound, service_.judged());
}

std::array<Invariant, ChargingReferees::lasting> ChargingReferees::lasting_invariants() const {
  const cia419::Charger& charger = devices_->charger().charger();
  const ChargingPlant& plant = devices_->plant();
  return {count_invariant(InvariantKind::ampere_hours, charger.ampere_hours_total(),
                          plant.ampere_hours(), ampere_hours_floor),
          count_invariant(InvariantKind::energy, charger.energy_total_watt_hours(),
                          plant.energy_watt_hour(), watt_hours_floor),
          handshake(),
          {.kind = InvariantKind::current_before_ready,
           .worst = static_cast<double>(handshake_.begun_before_ready()),
           .held = handshake_.begun_before_ready() == 0,
           .judged = handshake_.begun()},
          service()};
}

std::vector<Invariant> ChargingReferees::invariants() const {
  const std::array<Invariant, lasting> now_lasting = lasting_invariants();
  const std::vector<Invariant> seen = faults_.invariants();
  std::vector<Invariant> all(now_lasting.begin(), now_lasting.end());
  all.insert(all.end(), seen.begin(), seen.end());
  return all;
}

}  // namespace canvoy::charging
