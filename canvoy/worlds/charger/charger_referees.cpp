#include "canvoy/worlds/charger/charger_referees.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::charger {

namespace {

/// Enough for a frame to wait for others and be sent again several times.
constexpr Duration frame_time_max = 50ms;

constexpr double percent = 100;
/// Energy and ampere-hours must agree to this share.
constexpr double count_bound_percent = 1;
/// The charge counts as at least this much, so that the first seconds do not decide.
constexpr double ampere_hours_floor = 1;
constexpr double watt_hours_floor = 50;

double error_percent(double counted, double truth, double floor) {
  return std::abs(counted - truth) / std::max(truth, floor) * percent;
}

/// Where nothing was delivered and nothing counted, there is no judgement.
Invariant count_invariant(InvariantKind kind, double counted, double truth, double floor) {
  const double value = error_percent(counted, truth, floor);
  return {.kind = kind,
          .worst = value,
          .allowed = count_bound_percent,
          .held = value <= count_bound_percent,
          .judged = truth > 0 || counted > 0 ? 1U : 0U};
}

/// An excess over the requested current by this share is too much.
constexpr double excess_share = 0.05;
constexpr double excess_ampere = 1;
/// A slower stage is not suitable for charging.
constexpr Duration stage_fall_time_bound = 500ms;
/// A cell tolerates this share above the limit of its management system.
constexpr double over_voltage_share = 0.02;

Invariant time_invariant(InvariantKind kind, Duration value, Duration bound, std::uint64_t judged) {
  return {.kind = kind,
          .worst = std::chrono::duration<double>(value).count(),
          .allowed = std::chrono::duration<double>(bound).count(),
          .held = value <= bound,
          .judged = judged};
}

}  // namespace

ChargerReferees::ChargerReferees(const ChargerOptions& options, const ChargerDevices& devices,
                                 std::vector<ChargerEvent>& events)
    : options_(&options),
      devices_(&devices),
      events_(&events),
      handshake_(devices.rules()),
      faults_(options.faults, promises()),
      service_(
          std::min(options.charger.limits.current_max_ampere, options.stage.current_max_ampere)),
      unwanted_time_max_(find_unwanted_time_max()) {}

DetectionBounds ChargerReferees::promises() const {
  const HandshakeRules agreed = devices_->rules();
  return {.heartbeat_time = agreed.heartbeat_time,
          .data_time = agreed.data_time,
          .value_time = devices_->battery_settings().sensing_period +
                        agreed.data_time / options_->charger.pdo_periods_max,
          .reaction_time = options_->charger.control_period + frame_time_max};
}

void ChargerReferees::step(Time now) {
  const ChargingPlant& plant = devices_->plant();
  handshake_.on_step(now, plant.stage.pilot_signal(), plant.ampere());
  faults_.note(now, reason());
  service_.on_step(now, served_ampere(), plant.ampere());
  judge_care(now);
  report_broken(now);
}

/// Current that the battery is to get. With a real battery or charger it is unknown. A battery that
/// is colder or hotter than the charger allows gets none.
double ChargerReferees::served_ampere() const {
  const cia418::BatteryReadings& readings = devices_->battery().unit().readings();
  const cia419::ChargeLimits& limits = options_->charger.limits;
  const double celsius = readings.temperature_celsius.value_or(limits.temperature_min_celsius);
  const double margin = limits.temperature_hysteresis_kelvin;
  const bool asks = plays_both() && devices_->plant().stage.pilot_signal() && readings.ready &&
                    celsius > limits.temperature_min_celsius + margin &&
                    celsius < limits.temperature_max_celsius - margin;
  if (!asks) return 0;
  const BatteryPlant& cells = devices_->plant().battery;
  if (cells.design().asks) return readings.requested_current_ampere.value_or(0);
  return cells.is_full() ? 0 : cells.requested_ampere();
}

/// By the true state of the cells, whatever is reported on the bus. Without power the management
/// system requests nothing, but a second one in its place does. A battery that only measures bears
/// its charge current; its voltage is judged beside that.
double ChargerReferees::wanted_ampere() const {
  const bool can_ask = devices_->battery_has_power() || second_batteries_ != 0;
  const cia418::BatteryReadings truth = devices_->plant().battery.sense();
  const bool asks = can_ask && truth.ready && devices_->plant().stage.pilot_signal();
  if (!asks) return 0;
  const BatteryDesign& design = devices_->plant().battery.design();
  return design.asks ? truth.requested_current_ampere.value_or(0) : design.charge_current_ampere;
}

/// Without a current nothing harms the cells: that is no judgement.
void ChargerReferees::judge_care(Time now) {
  const ChargingPlant& plant = devices_->plant();
  if (!plays_both()) return;
  if (plant.ampere() <= ChargingPlant::no_current_ampere) {
    for (WrongTime* each : {&more_than_asked_, &hot_or_cold_, &over_voltage_}) each->rest(now);
    return;
  }
  more_than_asked_.judge(now,
                         plant.ampere() <= wanted_ampere() * (1 + excess_share) + excess_ampere);
  const double celsius = plant.battery.celsius();
  const cia419::ChargeLimits& limits = options_->charger.limits;
  const bool is_warm_enough = celsius >= limits.temperature_min_celsius;
  hot_or_cold_.judge(now, is_warm_enough && celsius <= limits.temperature_max_celsius);
  const BatteryDesign& design = plant.battery.design();
  const double limit_volt = design.chemistry->charge_voltage_volt * design.cells;
  over_voltage_.judge(now, plant.battery.terminal_volt() <= limit_volt * (1 + over_voltage_share));
}

void ChargerReferees::fault_began(Time now, std::size_t fault) {
  service_.fault_began(now, kind_of(fault));
  if (kind_of(fault) == FaultKind::duplicate_node_id) ++second_batteries_;
  faults_.began(fault, now, reason());
}

void ChargerReferees::fault_ended(Time now, std::size_t fault) {
  faults_.note(now, reason());
  faults_.ended(fault);
  service_.fault_ended(now, kind_of(fault));
  if (kind_of(fault) == FaultKind::duplicate_node_id) --second_batteries_;
}

/// Reports each invariant once, when it is broken.
void ChargerReferees::report_broken(Time now) {
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

/// The charger may need one period to react, and the stage time to fall; the referee sees both in
/// steps of the plant.
Duration ChargerReferees::stop_time_max() const {
  return options_->charger.control_period +
         std::min(devices_->plant().stage.fall_time_max(), stage_fall_time_bound) +
         2 * ChargingPlant::step_time;
}

/// The battery's request is on the bus after some time, or its silence is detected.
Duration ChargerReferees::find_unwanted_time_max() const {
  const DetectionBounds promised = promises();
  return promised.value_time + std::min(promised.data_time, promised.heartbeat_time) +
         frame_time_max + stop_time_max();
}

Invariant ChargerReferees::handshake() const {
  return time_invariant(InvariantKind::current_outside_handshake, handshake_.outside_max(),
                        stop_time_max(), handshake_.steps_with_current());
}

Invariant ChargerReferees::service() const {
  return time_invariant(InvariantKind::battery_left_waiting, service_.waiting_max(),
                        ServiceWatch::bound, service_.judged());
}

Invariant ChargerReferees::missing_charge() const {
  return {.kind = InvariantKind::less_than_asked,
          .worst = service_.missing_percent(),
          .allowed = ServiceWatch::missing_max_percent,
          .held = service_.missing_percent() <= ServiceWatch::missing_max_percent,
          .judged = service_.measured()};
}

std::array<Invariant, ChargerReferees::lasting> ChargerReferees::lasting_invariants() const {
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
          service(),
          missing_charge(),
          time_invariant(InvariantKind::more_than_asked, more_than_asked_.worst(),
                         unwanted_time_max_, more_than_asked_.judged()),
          time_invariant(InvariantKind::charged_hot_or_cold, hot_or_cold_.worst(),
                         unwanted_time_max_, hot_or_cold_.judged()),
          time_invariant(InvariantKind::over_voltage, over_voltage_.worst(), unwanted_time_max_,
                         over_voltage_.judged())};
}

std::vector<Invariant> ChargerReferees::invariants() const {
  const std::array<Invariant, lasting> now_lasting = lasting_invariants();
  const std::vector<Invariant> seen = faults_.invariants();
  std::vector<Invariant> all(now_lasting.begin(), now_lasting.end());
  all.insert(all.end(), seen.begin(), seen.end());
  return all;
}

}  // namespace canvoy::charger
