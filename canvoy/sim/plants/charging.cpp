#include "canvoy/sim/plants/charging.hpp"

namespace canvoy {

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
