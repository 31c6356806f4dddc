#include "canvoy/sim/taxi/taxi_soak.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::uint32_t faults_max = 6;
/// Of the end of the run, so that there is a trip that no fault touches.
constexpr Duration quiet = 90min;

Duration up_to(Random& random, Duration max) {
  return Duration(1ms) * random.below(static_cast<std::uint32_t>(max / Duration(1ms)));
}

/// From an instant to minutes.
Duration lasting(Random& random) {
  const Duration longest[] = {200ms, 3s, 30s, 5min};
  return Duration(1ms) + up_to(random, longest[random.below(4)]);
}

ScheduledFault any_fault(Random& random, Time start) {
  ScheduledFault fault{
      .kind = static_cast<FaultKind>(random.below(static_cast<std::uint32_t>(fault_kinds))),
      .start = start,
      .duration = lasting(random)};
  if (has_node(fault.kind)) {
    const auto nodes = static_cast<std::uint32_t>(device_names.size());
    fault.node = static_cast<NodeId>(1 + random.below(nodes));
  }
  return fault;
}

}  // namespace

TaxiOptions soak_taxi(std::uint64_t seed, Duration time) {
  Random random(seed);
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = time;
  options.alarm = up_to(random, time);
  std::vector<ScheduledFault>& faults = options.faults.faults;
  const unsigned count = 1 + random.below(faults_max);
  while (faults.size() < count) {
    const bool at_start = random.below(8) == 0;
    const ScheduledFault first =
        any_fault(random, at_start ? Time{} : Time(up_to(random, time - quiet)));
    faults.push_back(first);
    if (random.below(2) == 0) continue;
    const Time meets[] = {first.start, first.start + up_to(random, first.duration + 1ms),
                          first.end()};
    faults.push_back(any_fault(random, meets[random.below(3)]));
  }
  return options;
}

void enlarge_wheels(TaxiOptions& options) {
  options.car.wheel_circumference_m *= 1.05;
}

}  // namespace canvoy::taxi
