// The power stage of a battery charger, as a plant: a current source with a limit, a slope and a
// meter (what a CiA 419 charger drives and senses).
//
//     PowerStagePlant stage({.current_max_ampere = 80});
//     stage.hardware().deliver(60.0);
//     const double ampere = stage.step(100ms, battery_volt);
#pragma once

#include <optional>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia419/charger_hardware.hpp"

namespace canvoy {

struct PowerStageOptions {
  double current_max_ampere = 80;
  double rise_ampere_per_second = 20;
  double fall_ampere_per_second = 400;
  double efficiency = 0.93;  ///< of what it takes from the mains, what the battery gets
  double meter_gain = 1.0;   ///< what it measures, for each ampere that flows
  double meter_offset_ampere = 0.02;
};

/// What is wrong with it; nothing by default.
struct PowerStageFaults {
  bool pilot_signal_is_lost = false;
  /// It delivers this, whatever it is told: a contactor that is welded.
  std::optional<double> stuck_ampere{};
};

class PowerStagePlant {
 public:
  explicit PowerStagePlant(const PowerStageOptions& options = {}) : options_(options) {}

  /// What flows on average during the next `time`, in A. Without a battery (`is_plugged` false)
  /// nothing does. Call it with even steps: a new set-point counts from the next step on.
  double step(Duration time, double battery_volt, bool is_plugged = true);

  /// For the device; valid as long as the plant.
  cia419::ChargerHardware hardware();
  PowerStageFaults faults{};

  double set_point_ampere() const { return set_point_ampere_; }
  /// At the end of the last step.
  double ampere() const { return ampere_; }
  double measured_ampere() const;
  bool pilot_signal() const { return is_plugged_ && !faults.pilot_signal_is_lost; }
  /// Taken from the mains since the start.
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
