// What a cell does by its chemistry: open-circuit voltage and resistance over its state of charge.
//
//     const double open_circuit = lead_acid.open_circuit_volt(0.8);
#pragma once

#include <span>

namespace canvoy {

/// A cell at 25 °C that has rested.
struct CellPoint {
  double state_of_charge = 0;  ///< 0 to 1
  double open_circuit_volt = 0;
  double resistance_ohm_ampere_hour = 0;  ///< to charge; divided by the capacity, in ohm
};

/// Constant data; between its points it is straight.
struct CellChemistry {
  std::span<const CellPoint> points;  ///< from state of charge 0 to 1, ascending
  double charge_voltage_volt = 0;     ///< what a management system holds a cell to
  double charge_efficiency = 1;       ///< of the ampere-hours that go in, those that stay
  double resistance_per_kelvin = 0;   ///< share by which the resistance grows per kelvin of cold

  double open_circuit_volt(double state_of_charge) const;
  /// Of a cell with `capacity_ampere_hour`. Never below half of what it is at 25 °C.
  double resistance_ohm(double state_of_charge, double celsius, double capacity_ampere_hour) const;
};

/// A flooded traction cell. Its resistance to charge rises steeply towards the end, where it
/// gasses.
extern const CellChemistry lead_acid;
/// A lithium iron phosphate cell: flat, efficient, steep only at the ends.
extern const CellChemistry lithium_iron_phosphate;

}  // namespace canvoy
