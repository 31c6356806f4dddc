#include "canvoy/sim/plants/cell_chemistry.hpp"

#include <algorithm>
#include <array>

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

}  // namespace canvoy
