#include "canvoy/worlds/police/police_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::police {

namespace {

constexpr std::uint32_t police_faults_max = 6;
/// At the end of the run, so that one call is without faults.
constexpr Duration police_quiet = 90min;

ScheduledFault any_police_fault(Random& random, Time start) {
  return soak_fault<FaultKind>(random, start, device_names.size(),
                               [](std::size_t i) { return static_cast<NodeId>(i + 1); });
}

}  // namespace

PoliceOptions soak_police(std::uint64_t seed, Duration time) {
  Random random(seed);
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = time;
  options.faults.faults =
      soak_faults(random, police_faults_max, time - police_quiet, any_police_fault);
  return options;
}

void darken(PoliceOptions& options) {
  options.sabotage.cuts_flashers = true;
}

}  // namespace canvoy::police
