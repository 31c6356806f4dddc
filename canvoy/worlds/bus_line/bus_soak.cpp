#include "canvoy/worlds/bus_line/bus_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::uint32_t bus_faults_max = 6;
/// At the end of the run, so that one journey is without faults.
constexpr Duration bus_quiet = 30min;

ScheduledFault any_bus_fault(Random& random, Time start) {
  return soak_fault<FaultKind>(random, start, places_of(BusDesign{}.cars).size(),
                               [](std::size_t i) { return device_places.at(i).id; });
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

}  // namespace canvoy::bus_line
