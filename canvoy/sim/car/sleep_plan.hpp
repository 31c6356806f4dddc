// The end of a day of a simulated car: its gateway sends the network to sleep, and some time later
// somebody opens a door, and it wakes up.
//
//     plan_sleep(bus, {.sleep = now + 1min, .wake = now + 20min});
#pragma once

#include <optional>

#include "canvoy/sim/car/car_bus.hpp"

namespace canvoy::car {

struct SleepPlan {
  Time sleep{};
  /// A stranger sends a frame, for who looks whether that is seen.
  std::optional<Time> stranger_speaks{};
  Time wake{};
};

/// Nothing sleeps where the gateway is not played, or has no power then; one without power when it
/// shall wake up does so when that comes back. The bus must outlive the world's last run.
void plan_sleep(CarBus& bus, const SleepPlan& plan);

}  // namespace canvoy::car
