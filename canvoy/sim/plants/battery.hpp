// A traction battery with its management system, as a plant: cells that take charge and grow warm,
// and electronics that measure them and request current (the readings of a CiA 418 battery module).
//
//     BatteryPlant battery(BatteryPlant::lead_acid_48v(), 0.2);
//     battery.step(60.0, 100ms);
//     const cia418::BatteryReadings readings = battery.hardware().sense();
#pragma once

#include <optional>
#include <span>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"

namespace canvoy {

// Properties of a cell by its chemistry: open-circuit voltage and resistance over its state of
// charge.
//
//     const double open_circuit = lead_acid.open_circuit_volt(0.8);

/// A point of a cell at 25 °C that has rested.
struct CellPoint {
  double state_of_charge = 0;             ///< 0 to 1
  double open_circuit_volt = 0;           ///< without current
  double resistance_ohm_ampere_hour = 0;  ///< to charge; times the capacity, in ohm ampere-hours
};

/// Constant data, interpolated linearly between its points.
struct CellChemistry {
  std::span<const CellPoint> points;  ///< from state of charge 0 to 1, ascending
  double charge_voltage_volt = 0;     ///< limit to which a management system holds a cell
  double charge_efficiency = 1;       ///< share of the ampere-hours charged that remain
  double resistance_per_kelvin = 0;   ///< growth of the resistance per kelvin below 25 °C

  /// Voltage of a rested cell without current; `state_of_charge` is clamped to 0 to 1.
  double open_circuit_volt(double state_of_charge) const;
  /// Resistance of a cell with `capacity_ampere_hour`. Never below half of its value at 25 °C.
  double resistance_ohm(double state_of_charge, double celsius, double capacity_ampere_hour) const;
};

/// A flooded traction cell. Its resistance to charge rises steeply towards the end, where it
/// gasses.
extern const CellChemistry lead_acid;
/// A lithium iron phosphate cell: flat and efficient, steep only at the ends.
extern const CellChemistry lithium_iron_phosphate;

/// Design of a battery.
struct BatteryDesign {
  const CellChemistry* chemistry = nullptr;  ///< of each cell
  unsigned cells = 0;                        ///< in series
  double capacity_ampere_hour = 0;           ///< of the cells
  double charge_current_ampere = 0;          ///< requested while the voltage is below its limit
  double tail_current_ampere = 0;  ///< the battery is full when it requests no more than this
  double heat_capacity_joule_per_kelvin = 0;  ///< of the whole battery
  double heat_loss_watt_per_kelvin = 0;       ///< to the surroundings
  double celsius_min = -20;                   ///< outside of these limits it is not ready
  double celsius_max = 60;                    ///< outside of these limits it is not ready
  /// False: its module only measures. It requests no current, does not know its state of charge,
  /// and is ready also when it is full.
  bool asks = true;
};

/// Faults of the sensors and of the management system; none by default.
struct BatteryFaults {
  bool temperature_is_invalid = false;    ///< the sensor is broken
  bool voltage_is_invalid = false;        ///< the sensor is broken
  bool is_not_ready = false;              ///< the management system refuses a charge
  std::optional<double> shown_celsius{};  ///< reading of the sensor, whatever the cells have
};

/// Real quantities, unlike the measured ones. All are totals since the start.
struct BatteryTruth {
  double ampere_hours_in = 0;      ///< at the terminals
  double ampere_hours_out = 0;     ///< at the terminals
  double energy_in_joule = 0;      ///< at the terminals, less what was taken out
  double energy_stored_joule = 0;  ///< gained by the cells
  double heat_joule = 0;           ///< lost in them
  double celsius_max = 0;          ///< highest temperature of the cells
};

/// The plant. Its state changes by step() only.
class BatteryPlant {
 public:
  /// 24 cells of lead and acid, or 16 of lithium iron phosphate: 48 V, 400 Ah.
  static BatteryDesign lead_acid_48v();
  /// 16 cells of lithium iron phosphate: 48 V, 400 Ah.
  static BatteryDesign lithium_48v();

  /// `state_of_charge` is 0 to 1. The battery starts at the temperature of its surroundings.
  explicit BatteryPlant(const BatteryDesign& design, double state_of_charge,
                        double ambience_celsius = 20);

  /// Lets `ampere` flow in, or out where negative, for `time`.
  void step(double ampere, Duration time);

  /// Hardware for the device; valid as long as the plant.
  cia418::BatteryHardware hardware();
  BatteryFaults faults{};        ///< may be changed at any time
  double ambience_celsius = 20;  ///< of the surroundings; may be changed

  /// True state of charge of the cells, 0 to 1.
  double state_of_charge() const { return state_of_charge_; }
  /// True temperature of the cells.
  double celsius() const { return celsius_; }
  /// Voltage at the terminals after the last step.
  double terminal_volt() const { return terminal_volt_; }
  /// Current that the management system requests, in A.
  double requested_ampere() const { return requested_ampere_; }
  /// True once the requested current has fallen to the tail current.
  bool is_full() const { return is_full_; }
  /// Readings that the management system would report.
  cia418::BatteryReadings sense() const;
  /// Totals, for a referee.
  const BatteryTruth& truth() const { return truth_; }
  /// Design that it was made with.
  const BatteryDesign& design() const { return design_; }

 private:
  void charge_cells(double ampere, double seconds);
  void exchange_heat(double heat_joule, double seconds);
  void manage(double ampere, double seconds);
  double resistance_ohm() const;
  double open_circuit_volt() const;

  BatteryDesign design_;
  double state_of_charge_;
  double celsius_;
  double terminal_volt_;
  double requested_ampere_;
  double wants_little_seconds_ = 0;
  bool is_full_ = false;
  double ampere_hours_since_charge_;
  BatteryTruth truth_;
};

}  // namespace canvoy
