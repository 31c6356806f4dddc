// Properties of a cell by its chemistry: open-circuit voltage and resistance over its state of
// charge.
//
//     const double open_circuit = lead_acid.open_circuit_volt(0.8);
#pragma once

#include <span>

namespace canvoy {

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

}  // namespace canvoy
