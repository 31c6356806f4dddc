#include "canvoy/worlds/excavator/excavator_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::excavator {

namespace {

constexpr std::uint32_t excavator_faults_max = 6;
/// At the end of the run, so that a part of it is without faults.
constexpr Duration excavator_quiet = 10min;

ScheduledFault any_excavator_fault(Random& random, Time start) {
  return soak_fault<FaultKind>(random, start, device_places.size(),
                               [](std::size_t i) { return device_places.at(i).id; });
}

}  // namespace

ExcavatorOptions soak_excavator(std::uint64_t seed, Duration time) {
  Random random(seed);
  ExcavatorOptions options;
  options.faults.seed = seed;
  options.length = time;
  options.shift.work = 25min;
  options.shift.rest = 3min;
  options.faults.faults =
      soak_faults(random, excavator_faults_max, time - excavator_quiet, any_excavator_fault);
  return options;
}

void darken(ExcavatorOptions& options) {
  options.sabotage.burnt_lamp = true;
}

}  // namespace canvoy::excavator
