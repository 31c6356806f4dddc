#include "canvoy/devices/cia419/charge_control.hpp"

#include <algorithm>

namespace canvoy::cia419 {

ChargeDecision ChargeControl::decide(const ChargeInputs& inputs) {
  StopReason reason = communication_reason(inputs);
  if (reason == StopReason::none) reason = battery_reason(inputs);
  if (reason != StopReason::none) return {0, reason};
  const double own = inputs.curve_ampere.value_or(limits_.current_without_request_ampere);
  const double asked = inputs.has_request ? inputs.requested_ampere.value_or(0) : own;
  const double ampere =
      std::min({asked, limits_.current_max_ampere, inputs.battery_max_ampere.value_or(asked)});
  if (ampere <= 0) return {0, StopReason::no_request};
  return {ampere * derating(*inputs.temperature_celsius), StopReason::none};
}

/// 0 to 1, of a temperature that stops nothing.
double ChargeControl::derating(double celsius) const {
  const double way = limits_.temperature_derating_kelvin;
  return way > 0 ? std::clamp((limits_.temperature_max_celsius - celsius) / way, 0.0, 1.0) : 1;
}

double ChargeControl::voltage_min(const ChargeInputs& inputs) const {
  return std::max(limits_.voltage_min_volt,
                  limits_.cell_voltage_min_volt * inputs.battery_cells.value_or(0));
}

StopReason ChargeControl::communication_reason(const ChargeInputs& inputs) const {
  if (!inputs.pilot_signal) return StopReason::no_pilot_signal;
  if (inputs.bus_off) return StopReason::bus_off;
  if (!inputs.linked) return StopReason::no_battery;
  if (!inputs.heartbeat_alive) return StopReason::heartbeat_lost;
  if (!inputs.operational) return StopReason::not_operational;
  if (!inputs.data_fresh) return StopReason::battery_data_missed;
  return StopReason::none;
}

StopReason ChargeControl::battery_reason(const ChargeInputs& inputs) {
  // A full battery reports that by its state of charge, and is not ready from then on.
  if (inputs.state_of_charge_percent.value_or(0) >= 100) return StopReason::battery_full;
  if (!inputs.battery_ready) return StopReason::battery_not_ready;
  if (!inputs.temperature_celsius) return StopReason::invalid_temperature;
  if (inputs.has_voltage && !inputs.voltage_volt) return StopReason::invalid_voltage;
  temperature_stop_ = temperature_reason(*inputs.temperature_celsius);
  if (temperature_stop_ != StopReason::none) return temperature_stop_;
  if (inputs.voltage_volt.value_or(0) > limits_.voltage_max_volt)
    return StopReason::voltage_too_high;
  if (inputs.voltage_volt && *inputs.voltage_volt < voltage_min(inputs)) {
    return StopReason::voltage_too_low;
  }
  return StopReason::none;
}

StopReason ChargeControl::temperature_reason(double celsius) {
  const double way_back = limits_.temperature_hysteresis_kelvin;
  const bool was_hot = temperature_stop_ == StopReason::too_hot;
  const bool was_cold = temperature_stop_ == StopReason::too_cold;
  // A reading is rounded: cells that are said to be at a limit may be beyond it.
  const double highest = limits_.temperature_max_celsius;
  const double lowest = limits_.temperature_min_celsius;
  if (was_hot ? celsius > highest - way_back : celsius >= highest) return StopReason::too_hot;
  if (was_cold ? celsius < lowest + way_back : celsius <= lowest) return StopReason::too_cold;
  return StopReason::none;
}

}  // namespace canvoy::cia419
