#include "canvoy/sim/bus/bus_soak.hpp"

namespace canvoy::bus {

namespace {

constexpr std::uint32_t bus_faults_max = 6;
/// At the end of the run, so that there is a journey that no fault touches.
constexpr Duration bus_quiet = 30min;

Duration bus_up_to(Random& random, Duration max) {
  return Duration(1ms) * random.below(static_cast<std::uint32_t>(max / Duration(1ms)));
}

/// From an instant to minutes.
Duration bus_lasting(Random& random) {
  const Duration longest[] = {200ms, 3s, 30s, 5min};
  return Duration(1ms) + bus_up_to(random, longest[random.below(4)]);
}

ScheduledFault any_bus_fault(Random& random, Time start) {
  ScheduledFault fault{
      .kind = static_cast<FaultKind>(random.below(static_cast<std::uint32_t>(fault_kinds))),
      .start = start,
      .duration = bus_lasting(random)};
  if (has_node(fault.kind)) {
    constexpr auto nodes = static_cast<std::uint32_t>(device_places.size());
    fault.node = device_places.at(random.below(nodes)).id;
  }
  return fault;
}

}  // namespace

BusNetworkOptions soak_bus(std::uint64_t seed, Duration time) {
  Random random(seed);
  BusNetworkOptions options;
  options.faults.seed = seed;
  options.length = time;
  std::vector<ScheduledFault>& faults = options.faults.faults;
  const unsigned count = 1 + random.below(bus_faults_max);
  while (faults.size() < count) {
    const bool at_start = random.below(8) == 0;
    const ScheduledFault first =
        any_bus_fault(random, at_start ? Time{} : Time(bus_up_to(random, time - bus_quiet)));
    faults.push_back(first);
    if (random.below(2) == 0) continue;
    const Time meets[] = {first.start, first.start + bus_up_to(random, first.duration + 1ms),
                          first.end()};
    faults.push_back(any_bus_fault(random, meets[random.below(3)]));
  }
  return options;
}

void freeze(BusNetworkOptions& options) {
  options.sabotage.freezes_destination = true;
}

}  // namespace canvoy::bus
