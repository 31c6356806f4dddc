// Decides whether a charger may deliver current, how much, and if not, why: a pure function of the
// charger's inputs.
//
//     ChargeDecision decision = ChargeControl(limits).decide(inputs);
//     hardware.deliver(decision.ampere);
#pragma once

#include <cstdint>
#include <optional>

namespace canvoy::cia419 {

/// Limits of the charger itself; the requests of the battery are in the inputs.
struct ChargeLimits {
  double current_max_ampere = 60;  ///< of the power stage
  double voltage_max_volt = 65;    ///< at which it stops
  double voltage_min_volt = 0;     ///< no battery of this charger has less
  /// Multiplied by the number of cells that the battery reports (CiA 418, 6020h): below that
  /// voltage, some of them are dead, or it is another battery than reported. Half a volt is less
  /// than a chargeable cell of any chemistry has; 0: not checked.
  double cell_voltage_min_volt = 0.5;
  double temperature_min_celsius = 0;        ///< there and below: stop
  double temperature_max_celsius = 50;       ///< there and above: stop
  double temperature_hysteresis_kelvin = 2;  ///< decrease that ends a stop for temperature
  /// From this distance below `temperature_max_celsius`, the current decreases linearly to 0 at
  /// that temperature; 0: it does not.
  double temperature_derating_kelvin = 0;
  /// Current if the battery offers no TPDO with a requested current; 0: such a battery is not
  /// charged.
  double current_without_request_ampere = 0;
};

/// Reasons for no current, the most serious first.
enum class StopReason : std::uint8_t {
  none,
  no_pilot_signal,
  bus_off,
  no_battery,  ///< not found, or not yet linked
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
  no_request,  ///< the battery requests no current, or an invalid one
};

/// State of charger and battery at one moment.
struct ChargeInputs {
  bool pilot_signal = false;                  ///< the plug of the battery is in
  bool bus_off = false;                       ///< the controller is off the bus
  bool linked = false;                        ///< the PDOs are linked to a battery
  bool heartbeat_alive = false;               ///< of the battery
  bool operational = false;                   ///< NMT state of this node
  bool data_fresh = false;                    ///< no linked RPDO is late
  bool battery_ready = false;                 ///< battery status, 7.2.1
  std::optional<double> temperature_celsius;  ///< absent: invalid
  bool has_voltage = false;                   ///< the battery sends its voltage (RPDO 2 is linked)
  std::optional<double> voltage_volt;         ///< absent: invalid
  bool has_request = false;  ///< the battery sends its requested current (RPDO 3 is linked)
  std::optional<double> requested_ampere;         ///< absent: invalid
  std::optional<double> state_of_charge_percent;  ///< 0 to 100; absent: invalid
  std::optional<double> battery_max_ampere = {};  ///< limit of the battery (CiA 418, 6020h)
  std::optional<double> battery_cells = {};       ///< in series (CiA 418, 6020h)
  /// By the charger's own curve, for a battery that sends no request; empty: it has none.
  std::optional<double> curve_ampere = {};
};

/// What to do, and why.
struct ChargeDecision {
  double ampere = 0;                     ///< current to deliver; 0: none
  StopReason reason = StopReason::none;  ///< none while current flows
};

class ChargeControl {
 public:
  /// Takes the limits of a charger.
  explicit ChargeControl(const ChargeLimits& limits) : limits_(limits) {}

  /// Keeps only which stop for temperature holds, for the hysteresis.
  ChargeDecision decide(const ChargeInputs& inputs);

  /// The limits that it was made with.
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
