#include "canvoy/sim/bus/bus_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::bus {

namespace {

constexpr std::uint32_t bus_faults_max = 6;
/// At the end of the run, so that there is a journey that no fault touches.
constexpr Duration bus_quiet = 30min;

ScheduledFault any_bus_fault(Random& random, Time start) {
  auto fault = soak_fault<ScheduledFault>(random, fault_kinds, start);
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
  options.faults.faults = soak_faults(random, bus_faults_max, time - bus_quiet, any_bus_fault);
  return options;
}

void freeze(BusNetworkOptions& options) {
  options.sabotage.freezes_destination = true;
}

}  // namespace canvoy::bus
