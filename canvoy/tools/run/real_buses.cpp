#include "canvoy/tools/run/real_buses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace canvoy::tools {

namespace {

/// Between two looks, where the machine did not get to it for longer. While the network is late it
/// runs twice as fast as the clock.
constexpr Duration step_max = 5ms;
constexpr Duration step_min = 2 * RealBuses::period;
/// By which it may be late. Until then nothing is left out: the plant behind a real drive counts its
/// metres by the time.
constexpr Duration late_max = 10s;

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
  late_ += passed;
  const Duration step = std::min(late_, std::clamp(passed, step_min, step_max));
  late_ -= step;
  left_out_ += std::max(late_ - late_max, Duration{});
  late_ = std::min(late_, late_max);
  return reached_ += step;
}

}  // namespace canvoy::tools
