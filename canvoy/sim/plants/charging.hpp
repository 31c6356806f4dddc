// A battery at a charger, as a plant: the current of the power stage flows into the battery while
// the plug is in.
//
//     ChargingPlant plant(BatteryPlant::lead_acid_48v(), 0.2);
//     world.add_plant(plant.on_step(), ChargingPlant::step_time);
#pragma once

#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"
#include "canvoy/sim/plants/battery.hpp"

namespace canvoy {

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
