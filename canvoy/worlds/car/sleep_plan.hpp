// The end of a day of a simulated car: its gateway sends the network to sleep; some time later a
// door is opened, and the network wakes up.
//
//     plan_sleep(bus, {.sleep = now + 1min, .wake = now + 20min});
#pragma once

#include <optional>

#include "canvoy/worlds/car/car_bus.hpp"

namespace canvoy::car {

struct SleepPlan {
  Time sleep{};  ///< the gateway sends the network to sleep
  /// Time at which a foreign device sends a frame, for tests that this is detected.
  std::optional<Time> stranger_speaks{};
  Time wake{};  ///< a door is opened; after `sleep`
};

/// Plans sleep and waking. No device sleeps where the gateway is not simulated here, or has no
/// power at that time. A gateway without power at the time of waking wakes the network when power
/// returns. The bus must outlive the world's last run.
void plan_sleep(CarBus& bus, const SleepPlan& plan);

}  // namespace canvoy::car
