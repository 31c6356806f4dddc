// The load on the ropes of a car, as a plant: the car and the people in it, spread over the ropes.
//
//     LoadCell cell({.car_mass_kg = 1100, .ropes = 4});
//     cia417::LoadMeasuringDevice<..., 4> load(port, 13, cell.hardware(), {.tare_kg = 1100});
//     cell.set_load(450);
//     load.unit().hardware_changed();
#pragma once

#include <optional>

#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"

namespace canvoy::lift {

/// Masses and ropes of a car, and the errors of the measurement.
struct LoadCellOptions {
  double car_mass_kg = 1100;  ///< of the empty car
  unsigned ropes = 1;         ///< each with a sensor
  double rope_ratio = 1;      ///< 2 for a car that hangs by a pulley (2:1): the ropes carry half of
                              ///< it
  double unevenness = 0;      ///< share that the first rope carries more, and the last one less
  double meter_gain = 1.0;    ///< kilograms that are measured for each kilogram
};

class LoadCell {
 public:
  /// A cell with an empty car, and all sensors working.
  explicit LoadCell(const LoadCellOptions& options = {}) : options_(options) {}

  /// Mass of the people and goods in the car.
  void set_load(double kilograms) { load_kg_ = kilograms; }
  /// Breaks the sensor of a rope, from 1 on; 0: all work.
  void break_sensor(unsigned rope) { broken_rope_ = rope; }

  /// True load, whatever the sensors measure.
  double load_kg() const { return load_kg_; }
  /// Hardware for the device; valid as long as this object.
  cia417::LoadHardware hardware() { return {.rope_load = callback<&LoadCell::rope>(*this)}; }

 private:
  std::optional<double> rope(unsigned number) {
    if (number == broken_rope_) return std::nullopt;
    const double all = (options_.car_mass_kg + load_kg_) / options_.rope_ratio;
    const double place =
        options_.ropes > 1 ? 1.0 - 2.0 * (number - 1.0) / (options_.ropes - 1.0) : 0.0;
    return all / options_.ropes * (1 + options_.unevenness * place) * options_.meter_gain;
  }

  LoadCellOptions options_;
  double load_kg_ = 0;
  unsigned broken_rope_ = 0;
};

}  // namespace canvoy::lift
