// A battery at a charger, as a plant: what the power stage delivers flows into the battery while
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

class ChargingPlant {
 public:
  /// Short against all that a charger reacts to, and long enough for a night in a fraction of a
  /// second.
  static constexpr Duration step_time = 100ms;
  /// Below this none is said to flow: what a meter shows at rest.
  static constexpr double no_current_ampere = 0.01;

  ChargingPlant(const BatteryDesign& design, double state_of_charge, double ambience_celsius = 20,
                const PowerStageOptions& stage_options = {})
      : battery(design, state_of_charge, ambience_celsius), stage(stage_options) {}

  /// Goes on by one step_time.
  void step();
  /// For World::add_plant.
  Callback<void(Time)> on_step() {
    return {[](void* plant, Time) { static_cast<ChargingPlant*>(plant)->step(); }, this};
  }

  BatteryPlant battery;
  PowerStagePlant stage;
  bool is_plugged = true;

  /// The average of the last step, in A: the truth.
  double ampere() const { return ampere_; }
  /// Delivered into the battery since the start: the truth.
  double ampere_hours() const { return battery.truth().ampere_hours_in; }
  double energy_watt_hour() const { return battery.truth().energy_in_joule / 3600; }

 private:
  double ampere_ = 0;
};

}  // namespace canvoy
