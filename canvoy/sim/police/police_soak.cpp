#include "canvoy/sim/police/police_soak.hpp"

namespace canvoy::police {

namespace {

constexpr std::uint32_t police_faults_max = 6;
/// At the end of the run, so that there is a call that no fault touches.
constexpr Duration police_quiet = 90min;

Duration soak_up_to(Random& random, Duration max) {
  return Duration(1ms) * random.below(static_cast<std::uint32_t>(max / Duration(1ms)));
}

/// From an instant to minutes.
Duration police_lasting(Random& random) {
  const Duration longest[] = {200ms, 3s, 30s, 5min};
  return Duration(1ms) + soak_up_to(random, longest[random.below(4)]);
}

ScheduledFault any_police_fault(Random& random, Time start) {
  ScheduledFault fault{
      .kind = static_cast<FaultKind>(random.below(static_cast<std::uint32_t>(fault_kinds))),
      .start = start,
      .duration = police_lasting(random)};
  if (has_node(fault.kind)) {
    const auto nodes = static_cast<std::uint32_t>(device_names.size());
    fault.node = static_cast<NodeId>(1 + random.below(nodes));
  }
  return fault;
}

}  // namespace

PoliceOptions soak_police(std::uint64_t seed, Duration time) {
  Random random(seed);
  PoliceOptions options;
  options.faults.seed = seed;
  options.length = time;
  std::vector<ScheduledFault>& faults = options.faults.faults;
  const unsigned count = 1 + random.below(police_faults_max);
  while (faults.size() < count) {
    const bool at_start = random.below(8) == 0;
    const ScheduledFault first =
        any_police_fault(random, at_start ? Time{} : Time(soak_up_to(random, time - police_quiet)));
    faults.push_back(first);
    if (random.below(2) == 0) continue;
    const Time meets[] = {first.start, first.start + soak_up_to(random, first.duration + 1ms),
                          first.end()};
    faults.push_back(any_police_fault(random, meets[random.below(3)]));
  }
  return options;
}

void darken(PoliceOptions& options) {
  options.sabotage.cuts_flashers = true;
}

}  // namespace canvoy::police
