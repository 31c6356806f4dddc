// Whether a charger may deliver current, how much, and if not, why: a pure function of what the
// charger knows.
//
//     ChargeDecision decision = ChargeControl(limits).decide(inputs);
//     hardware.deliver(decision.ampere);
#pragma once

#include <cstdint>
#include <optional>

namespace canvoy::cia419 {

/// What the charger itself bears; what the battery asks for comes with the inputs.
struct ChargeLimits {
  double current_max_ampere = 60;
  double voltage_max_volt = 65;
  double voltage_min_volt = 0;  ///< below that no battery of this charger can be
  /// Times the number of cells that the battery tells (CiA 418, 6020h): below that some of them are
  /// dead, or it is another battery than it says. Half a volt is less than a cell of any chemistry
  /// has that may be charged; 0: not looked at.
  double cell_voltage_min_volt = 0.5;
  double temperature_min_celsius = 0;
  double temperature_max_celsius = 50;
  double temperature_hysteresis_kelvin = 2;  ///< the way back that ends a stop for temperature
  /// So far below `temperature_max_celsius` the current begins to fall, in a line, to nothing
  /// there; 0: it does not.
  double temperature_derating_kelvin = 0;
  /// Delivered where the battery offers no TPDO with a requested current; 0: do not charge such a
  /// battery.
  double current_without_request_ampere = 0;
};

/// Why no current flows, the most serious reason first.
enum class StopReason : std::uint8_t {
  none,
  no_pilot_signal,
  bus_off,
  no_battery,  ///< not found, or not linked yet
  heartbeat_lost,
  not_operational,      ///< this node is not in NMT state operational
  battery_data_missed,  ///< the deadline of a linked RPDO passed, or none came yet
  battery_not_ready,
  battery_full,
  invalid_temperature,
  invalid_voltage,
  too_hot,
  too_cold,
  voltage_too_high,
  voltage_too_low,
  no_request,  ///< the battery asks for no current, or for an invalid one
};

struct ChargeInputs {
  bool pilot_signal = false;
  bool bus_off = false;
  bool linked = false;
  bool heartbeat_alive = false;
  bool operational = false;
  bool data_fresh = false;
  bool battery_ready = false;
  std::optional<double> temperature_celsius;
  bool has_voltage = false;  ///< the battery sends its voltage (RPDO 2 is linked)
  std::optional<double> voltage_volt;
  bool has_request = false;  ///< the battery sends its requested current (RPDO 3 is linked)
  std::optional<double> requested_ampere;
  std::optional<double> state_of_charge_percent;
  std::optional<double> battery_max_ampere = {};  ///< that the battery bears (CiA 418, 6020h)
  std::optional<double> battery_cells = {};       ///< in series (CiA 418, 6020h)
};

struct ChargeDecision {
  double ampere = 0;
  StopReason reason = StopReason::none;
};

class ChargeControl {
 public:
  explicit ChargeControl(const ChargeLimits& limits) : limits_(limits) {}

  /// Remembers only which stop for temperature holds, for the hysteresis.
  ChargeDecision decide(const ChargeInputs& inputs);

  const ChargeLimits& limits() const { return limits_; }

 private:
  StopReason communication_reason(const ChargeInputs& inputs) const;
  StopReason battery_reason(const ChargeInputs& inputs);
  StopReason temperature_reason(double celsius);
  double voltage_min(const ChargeInputs& inputs) const;
  double derating(double celsius) const;

  ChargeLimits limits_;
  StopReason temperature_stop_ = StopReason::none;
};

}  // namespace canvoy::cia419
