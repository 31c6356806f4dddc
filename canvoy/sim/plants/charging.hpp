// A battery at a charger, as a plant: the current of the power stage flows into the battery while
// the plug is in.
//
//     ChargingPlant plant(BatteryPlant::lead_acid_48v(), 0.2);
//     world.add_plant(plant.on_step(), ChargingPlant::step_time);
#pragma once

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/plants/battery.hpp"
#include "canvoy/sim/plants/charger_power_stage.hpp"

namespace canvoy {

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
