// The power stage of a battery charger, as a plant: a current source with a limit, a slope and a
// meter (the hardware of a CiA 419 charger).
//
//     PowerStagePlant stage({.current_max_ampere = 80});
//     stage.hardware().deliver(60.0);
//     const double ampere = stage.step(100ms, battery_volt);
#pragma once

#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"

namespace canvoy {

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

}  // namespace canvoy
