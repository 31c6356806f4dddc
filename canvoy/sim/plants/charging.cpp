#include "canvoy/sim/plants/charging.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

constexpr double reference_celsius = 25;
constexpr double resistance_factor_min = 0.5;

// Rest voltages of 1.28 kg/l acid. With this resistance, a cell that takes a sixth of its capacity
// in an hour reaches 2.4 V when it is four fifths full.
constexpr std::array lead_acid_points{
    CellPoint{0.00, 1.930, 0.40}, CellPoint{0.20, 1.985, 0.45}, CellPoint{0.40, 2.030, 0.60},
    CellPoint{0.60, 2.070, 0.90}, CellPoint{0.70, 2.085, 1.30}, CellPoint{0.80, 2.100, 2.00},
    CellPoint{0.90, 2.115, 4.20}, CellPoint{0.95, 2.125, 6.00}, CellPoint{1.00, 2.140, 10.0},
};

constexpr std::array lithium_iron_phosphate_points{
    CellPoint{0.00, 2.800, 0.40}, CellPoint{0.05, 3.150, 0.24}, CellPoint{0.10, 3.200, 0.18},
    CellPoint{0.20, 3.250, 0.16}, CellPoint{0.40, 3.285, 0.16}, CellPoint{0.60, 3.300, 0.16},
    CellPoint{0.70, 3.320, 0.16}, CellPoint{0.90, 3.340, 0.18}, CellPoint{0.97, 3.400, 0.24},
    CellPoint{1.00, 3.550, 0.40},
};

double between(std::span<const CellPoint> points, double state_of_charge,
               double CellPoint::*value) {
  const double wanted = std::clamp(state_of_charge, 0.0, 1.0);
  std::size_t upper = 1;
  while (upper + 1 < points.size() && points[upper].state_of_charge < wanted) ++upper;
  const CellPoint& low = points[upper - 1];
  const CellPoint& high = points[upper];
  const double share =
      (wanted - low.state_of_charge) / (high.state_of_charge - low.state_of_charge);
  return low.*value + share * (high.*value - low.*value);
}

}  // namespace

const CellChemistry lead_acid{.points = lead_acid_points,
                              .charge_voltage_volt = 2.40,
                              .charge_efficiency = 0.92,
                              .resistance_per_kelvin = 0.012};

const CellChemistry lithium_iron_phosphate{.points = lithium_iron_phosphate_points,
                                           .charge_voltage_volt = 3.55,
                                           .charge_efficiency = 0.995,
                                           .resistance_per_kelvin = 0.02};

double CellChemistry::open_circuit_volt(double state_of_charge) const {
  return between(points, state_of_charge, &CellPoint::open_circuit_volt);
}

double CellChemistry::resistance_ohm(double state_of_charge, double celsius,
                                     double capacity_ampere_hour) const {
  const double factor = 1 + resistance_per_kelvin * (reference_celsius - celsius);
  return between(points, state_of_charge, &CellPoint::resistance_ohm_ampere_hour) /
         capacity_ampere_hour * std::max(factor, resistance_factor_min);
}

namespace {

constexpr double seconds_per_hour = 3600;
/// A battery counts as full when it requests no more than its tail current for this time, or when
/// warm cells, which always bear more, have had their whole charge for as long.
constexpr double full_after_seconds = 60;
/// A full battery is ready again when it has less than this share of its charge.
constexpr double recharge_below_state_of_charge = 0.95;
/// Ampere-hours taken out before the start, for each ampere-hour of capacity.
constexpr double earlier_cycles = 150;

double seconds_of(Duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

BatteryDesign BatteryPlant::lead_acid_48v() {
  return {.chemistry = &lead_acid,
          .cells = 24,
          .capacity_ampere_hour = 400,
          .charge_current_ampere = 60,
          .tail_current_ampere = 12,
          .heat_capacity_joule_per_kelvin = 700'000,
          .heat_loss_watt_per_kelvin = 12};
}

BatteryDesign BatteryPlant::lithium_48v() {
  return {.chemistry = &lithium_iron_phosphate,
          .cells = 16,
          .capacity_ampere_hour = 400,
          .charge_current_ampere = 60,
          .tail_current_ampere = 8,
          .heat_capacity_joule_per_kelvin = 160'000,
          .heat_loss_watt_per_kelvin = 6};
}

BatteryPlant::BatteryPlant(const BatteryDesign& design, double state_of_charge, double ambience)
    : ambience_celsius(ambience),
      design_(design),
      state_of_charge_(std::clamp(state_of_charge, 0.0, 1.0)),
      celsius_(ambience),
      terminal_volt_(open_circuit_volt()),
      requested_ampere_(design.charge_current_ampere),
      ampere_hours_since_charge_((1 - state_of_charge_) * design.capacity_ampere_hour) {
  truth_.celsius_max = celsius_;
}

void BatteryPlant::step(double ampere, Duration time) {
  const double seconds = seconds_of(time);
  charge_cells(ampere, seconds);
  manage(ampere, seconds);
}

void BatteryPlant::charge_cells(double ampere, double seconds) {
  const double open_circuit = open_circuit_volt();
  terminal_volt_ = open_circuit + ampere * resistance_ohm();
  const double kept = ampere > 0 ? ampere * design_.chemistry->charge_efficiency : ampere;
  const double energy_joule = terminal_volt_ * ampere * seconds;
  const double stored_joule = open_circuit * kept * seconds;

  state_of_charge_ = std::clamp(
      state_of_charge_ + kept * seconds / seconds_per_hour / design_.capacity_ampere_hour, 0.0,
      1.0);
  const double ampere_hours = ampere * seconds / seconds_per_hour;
  (ampere > 0 ? truth_.ampere_hours_in : truth_.ampere_hours_out) +=
      ampere > 0 ? ampere_hours : -ampere_hours;
  if (ampere < 0) ampere_hours_since_charge_ -= ampere_hours;
  truth_.energy_in_joule += energy_joule;
  truth_.energy_stored_joule += stored_joule;
  exchange_heat(energy_joule - stored_joule, seconds);
}

void BatteryPlant::exchange_heat(double heat_joule, double seconds) {
  const double lost_joule =
      (celsius_ - ambience_celsius) * design_.heat_loss_watt_per_kelvin * seconds;
  celsius_ += (heat_joule - lost_joule) / design_.heat_capacity_joule_per_kelvin;
  truth_.heat_joule += heat_joule;
  truth_.celsius_max = std::max(truth_.celsius_max, celsius_);
}

/// Requests constant current until that would raise the voltage above its limit; then the current
/// that keeps it there.
void BatteryPlant::manage(double ampere, double seconds) {
  if (is_full_) {
    if (state_of_charge_ >= recharge_below_state_of_charge) return;
    is_full_ = false;
    wants_little_seconds_ = 0;
  }
  const double limit_volt = design_.chemistry->charge_voltage_volt * design_.cells;
  const double bearable_ampere = (limit_volt - open_circuit_volt()) / resistance_ohm();
  requested_ampere_ = std::clamp(bearable_ampere, 0.0, design_.charge_current_ampere);
  if (ampere <= 0) return;  // only a battery that is being charged becomes full

  const bool wants_little =
      requested_ampere_ <= design_.tail_current_ampere || state_of_charge_ >= 1;
  wants_little_seconds_ = wants_little ? wants_little_seconds_ + seconds : 0;
  if (wants_little_seconds_ < full_after_seconds) return;
  is_full_ = true;
  requested_ampere_ = 0;
  ampere_hours_since_charge_ = 0;
}

cia418::BatteryHardware BatteryPlant::hardware() {
  return {.sense = callback<&BatteryPlant::sense>(*this)};
}

cia418::BatteryReadings BatteryPlant::sense() const {
  check_invariant(ampere_hours_since_charge_ >= 0);
  cia418::BatteryReadings readings;
  const double shown_celsius = faults.shown_celsius.value_or(celsius_);
  if (!faults.temperature_is_invalid) readings.temperature_celsius = shown_celsius;
  if (!faults.voltage_is_invalid) readings.voltage_volt = terminal_volt_;
  if (design_.asks) {
    readings.requested_current_ampere = requested_ampere_;
    // Reports 100 % when it is full, and not by counting alone.
    readings.state_of_charge_percent = is_full_ ? 100.0 : std::min(state_of_charge_ * 100, 99.0);
  }
  readings.ampere_hours_since_charge = ampere_hours_since_charge_;
  readings.ampere_hours_total =
      earlier_cycles * design_.capacity_ampere_hour + truth_.ampere_hours_out;
  const bool bears_charge =
      shown_celsius >= design_.celsius_min && shown_celsius <= design_.celsius_max;
  readings.ready = !(design_.asks && is_full_) && !faults.is_not_ready && bears_charge;
  return readings;
}

double BatteryPlant::resistance_ohm() const {
  return design_.cells * design_.chemistry->resistance_ohm(state_of_charge_, celsius_,
                                                           design_.capacity_ampere_hour);
}

double BatteryPlant::open_circuit_volt() const {
  return design_.cells * design_.chemistry->open_circuit_volt(state_of_charge_);
}

double PowerStagePlant::step(Duration time, double battery_volt, bool is_plugged) {
  is_plugged_ = is_plugged;
  if (!is_plugged) ampere_ = target_ampere_ = 0;
  const double seconds = std::chrono::duration<double>(time).count();
  const double way = target_ampere_ - ampere_;
  const double slope = way > 0 ? options_.rise_ampere_per_second : options_.fall_ampere_per_second;
  const double ramp_seconds = std::min(std::abs(way) / slope, seconds);
  const double end = ampere_ + std::copysign(ramp_seconds * slope, way);
  const double charge =
      (ampere_ + end) / 2 * ramp_seconds + end * (seconds - ramp_seconds);  // ampere-seconds
  ampere_ = end;
  // A set-point of this step cannot affect its beginning.
  const double wanted = faults.stuck_ampere.value_or(set_point_ampere_);
  target_ampere_ = is_plugged ? std::clamp(wanted, 0.0, options_.current_max_ampere) : 0;
  mains_energy_joule_ += charge * battery_volt / options_.efficiency;
  return charge / seconds;
}

double PowerStagePlant::measured_ampere() const {
  // The reading of the meter is zero while the stage is off.
  return ampere_ > 0 ? ampere_ * options_.meter_gain + options_.meter_offset_ampere : 0.0;
}

Duration PowerStagePlant::fall_time_max() const {
  return std::chrono::ceil<Duration>(
      std::chrono::duration<double>(options_.current_max_ampere / options_.fall_ampere_per_second));
}

cia419::ChargerHardware PowerStagePlant::hardware() {
  return {
      .deliver = callback<&PowerStagePlant::deliver>(*this),
      .current = {[](void* stage) {
                    return static_cast<PowerStagePlant*>(stage)->measured_ampere();
                  },
                  this},
      .pilot_signal = {
          [](void* stage) { return static_cast<PowerStagePlant*>(stage)->pilot_signal(); }, this}};
}

void ChargingPlant::step() {
  ampere_ = stage.step(step_time, battery.terminal_volt(), is_plugged);
  battery.step(ampere_, step_time);
}

void ChargingPlant::exchange(const BatteryPlant& next) {
  ampere_hours_before_ += battery.truth().ampere_hours_in - next.truth().ampere_hours_in;
  energy_before_joule_ += battery.truth().energy_in_joule - next.truth().energy_in_joule;
  const BatteryFaults faults = battery.faults;
  battery = next;
  battery.faults = faults;
}

}  // namespace canvoy
