// A battery at a charger, as a plant: the current of the power stage flows into the battery while
// the plug is in.
//
//     ChargingPlant plant(BatteryPlant::lead_acid_48v(), 0.2);
//     world.add_plant(plant.on_step(), ChargingPlant::step_time);
#pragma once

#include <optional>
#include <span>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia418/battery_hardware.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"

namespace canvoy {

// A traction battery with its management system, as a plant: cells that take charge and grow warm,
// and electronics that measure them and request current (the readings of a CiA 418 battery module).
//
//     BatteryPlant battery(BatteryPlant::lead_acid_48v(), 0.2);
//     battery.step(60.0, 100ms);
//     const cia418::BatteryReadings readings = battery.hardware().sense();

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

// The power stage of a battery charger, as a plant: a current source with a limit, a slope and a
// meter (the hardware of a CiA 419 charger).
//
//     PowerStagePlant stage({.current_max_ampere = 80});
//     stage.hardware().deliver(60.0);
//     const double ampere = stage.step(100ms, battery_volt);

/// Design of a power stage.
struct PowerStageOptions {
  double current_max_ampere = 80;       ///< a greater set-point counts as this
  double rise_ampere_per_second = 20;   ///< towards a greater set-point
  double fall_ampere_per_second = 400;  ///< towards a smaller one
  double efficiency = 0.93;           ///< share of the energy from the mains that the battery gets
  double meter_gain = 1.0;            ///< reading of the meter for each ampere that flows
  double meter_offset_ampere = 0.02;  ///< added to the reading while a current flows
};

/// Faults of the power stage; none by default.
struct PowerStageFaults {
  bool pilot_signal_is_lost = false;  ///< the pilot contact is open
  /// Current that flows whatever the set-point is: a welded contactor.
  std::optional<double> stuck_ampere{};
};

/// The plant. Its state changes by step() only.
class PowerStagePlant {
 public:
  /// Makes a stage without current, with a set-point of zero.
  explicit PowerStagePlant(const PowerStageOptions& options = {}) : options_(options) {}

  /// Average current during the next `time`, in A; none without a battery (`is_plugged` false).
  /// Call it with even steps: a new set-point takes effect with the next step.
  double step(Duration time, double battery_volt, bool is_plugged = true);

  /// Hardware for the device; valid as long as the plant.
  cia419::ChargerHardware hardware();
  PowerStageFaults faults{};  ///< may be changed at any time

  /// Set-point of the device.
  double set_point_ampere() const { return set_point_ampere_; }
  /// Current at the end of the last step, in A.
  double ampere() const { return ampere_; }
  /// Reading of the meter, with gain and offset; 0 while no current flows.
  double measured_ampere() const;
  /// True while the device senses a battery at its plug.
  bool pilot_signal() const { return is_plugged_ && !faults.pilot_signal_is_lost; }
  /// Energy taken from the mains since the start.
  double mains_energy_joule() const { return mains_energy_joule_; }
  /// The longest time from a set-point of zero to no current.
  Duration fall_time_max() const;

 private:
  void deliver(double ampere) { set_point_ampere_ = ampere; }

  PowerStageOptions options_;
  double set_point_ampere_ = 0;
  double target_ampere_ = 0;  ///< of the next step
  double ampere_ = 0;
  double mains_energy_joule_ = 0;
  bool is_plugged_ = true;
};

/// The plant. Its state changes by step() only.
class ChargingPlant {
 public:
  /// Shorter than all reaction times of a charger, and long enough to simulate a night in a
  /// fraction of a second.
  static constexpr Duration step_time = 100ms;
  /// A smaller current counts as none: the reading of a meter at rest.
  static constexpr double no_current_ampere = 0.01;

  /// Makes a battery at a charger. See BatteryPlant and PowerStagePlant.
  ChargingPlant(const BatteryDesign& design, double state_of_charge, double ambience_celsius = 20,
                const PowerStageOptions& stage_options = {})
      : battery(design, state_of_charge, ambience_celsius), stage(stage_options) {}

  /// Advances by one step_time.
  void step();
  /// Callback for World::add_plant.
  Callback<void(Time)> on_step() {
    return {[](void* plant, Time) { static_cast<ChargingPlant*>(plant)->step(); }, this};
  }

  /// Puts another battery at the cable; the faults of the sensors are those of the bay.
  void exchange(const BatteryPlant& next);

  BatteryPlant battery;    ///< at the plug
  PowerStagePlant stage;   ///< of the charger
  bool is_plugged = true;  ///< may be changed at any time

  /// True average current of the last step, in A.
  double ampere() const { return ampere_; }
  /// True charge delivered since the start, into this battery and those before it.
  double ampere_hours() const { return battery.truth().ampere_hours_in + ampere_hours_before_; }
  /// True energy delivered since the start, like ampere_hours(), in Wh.
  double energy_watt_hour() const {
    return (battery.truth().energy_in_joule + energy_before_joule_) / 3600;
  }

 private:
  double ampere_ = 0;
  // What the batteries before got here, less what this one had when it came.
  double ampere_hours_before_ = 0;
  double energy_before_joule_ = 0;
};

}  // namespace canvoy
