#include "canvoy/sim/plants/charging.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy {

double PowerStagePlant::step(Duration time, double battery_volt, bool is_plugged) {
  is_plugged_ = is_plugged;
  if (!is_plugged) ampere_ = target_ampere_ = 0;
  const double seconds = std::chrono::duration<double>(time).count();
  const double way = target_ampere_ - ampere_;
  const double slope = way > 0 ? options_.rise_ampere_per_second : options_.fall_ampere_per_second;
  const double ramp_seconds = std::min(std::abs(way) / slope, seconds);
  const double end = ampere_ + std::copysign(ramp_seconds * slope, way);
  const double charge =
      (ampere_ + end) / 2 * ramp_seconds + end * (seconds - ramp_seconds);  // ampere-seconds
  ampere_ = end;
  // A set-point of this step cannot affect its beginning.
  const double wanted = faults.stuck_ampere.value_or(set_point_ampere_);
  target_ampere_ = is_plugged ? std::clamp(wanted, 0.0, options_.current_max_ampere) : 0;
  mains_energy_joule_ += charge * battery_volt / options_.efficiency;
  return charge / seconds;
}

double PowerStagePlant::measured_ampere() const {
  // The reading of the meter is zero while the stage is off.
  return ampere_ > 0 ? ampere_ * options_.meter_gain + options_.meter_offset_ampere : 0.0;
}

Duration PowerStagePlant::fall_time_max() const {
  return std::chrono::ceil<Duration>(
      std::chrono::duration<double>(options_.current_max_ampere / options_.fall_ampere_per_second));
}

cia419::ChargerHardware PowerStagePlant::hardware() {
  return {
      .deliver = callback<&PowerStagePlant::deliver>(*this),
      .current = {[](void* stage) {
                    return static_cast<PowerStagePlant*>(stage)->measured_ampere();
                  },
                  this},
      .pilot_signal = {
          [](void* stage) { return static_cast<PowerStagePlant*>(stage)->pilot_signal(); }, this}};
}

void ChargingPlant::step() {
  ampere_ = stage.step(step_time, battery.terminal_volt(), is_plugged);
  battery.step(ampere_, step_time);
}

void ChargingPlant::exchange(const BatteryPlant& next) {
  ampere_hours_before_ += battery.truth().ampere_hours_in - next.truth().ampere_hours_in;
  energy_before_joule_ += battery.truth().energy_in_joule - next.truth().energy_in_joule;
  const BatteryFaults faults = battery.faults;
  battery = next;
  battery.faults = faults;
}

}  // namespace canvoy
