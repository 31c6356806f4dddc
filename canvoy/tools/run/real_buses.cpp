#include "canvoy/tools/run/real_buses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace canvoy::tools {

namespace {

/// Between two looks, where the machine did not get to it for longer.
constexpr Duration step_max = 5ms;

}  // namespace

RealBuses::RealBuses(World& world, const std::vector<RealBus>& buses, host::EventLoop& loop)
    : looked_at_(loop.now()), reached_(world.now()) {
  for (const RealBus& each : buses) {
    BusBridge& bridge = bridges_.emplace_back(world, each.bus, loop, each.address);
    bridge.real().on_trouble(
        [](const host::Error& error) { fmt::print(stderr, "canvoy: {}\n", error.line()); });
    world.start(bridge.slot());
  }
}

Time RealBuses::reach(Time clock) {
  const Duration passed = clock - std::exchange(looked_at_, clock);
  const Duration step = std::min(passed, step_max);
  left_out_ += passed - step;
  return reached_ += step;
}

}  // namespace canvoy::tools
