#include "canvoy/sim/plants/charging.hpp"

namespace canvoy {

void ChargingPlant::step() {
  ampere_ = stage.step(step_time, battery.terminal_volt(), is_plugged);
  battery.step(ampere_, step_time);
}

}  // namespace canvoy
