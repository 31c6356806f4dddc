#include "canvoy/sim/charging/charging_soak.hpp"

namespace canvoy::charging {

namespace {

constexpr unsigned faults_max = 8;
constexpr Duration last_fault = 30s;
constexpr double welded_ampere = 30;

Duration up_to(Random& random, Duration max) {
  return Duration(1ms) * random.below(static_cast<std::uint32_t>(max / Duration(1ms)));
}

/// From an instant to minutes.
Duration lasting(Random& random) {
  const Duration longest[] = {200ms, 3s, 30s, 5min};
  return Duration(1ms) + up_to(random, longest[random.below(4)]);
}

ScheduledFault any_fault(Random& random, Time start) {
  const auto kind = static_cast<FaultKind>(random.below(static_cast<std::uint32_t>(fault_kinds)));
  return {kind, start, lasting(random)};
}

/// Half of the faults meet another one: at the same time, while it lasts, or as it ends.
void add_faults(std::vector<ScheduledFault>& faults, Random& random, Duration time) {
  const unsigned count = 1 + random.below(faults_max);
  while (faults.size() < count) {
    const bool at_start = random.below(8) == 0;
    const ScheduledFault first = any_fault(random, at_start ? Time{} : Time(up_to(random, time)));
    faults.push_back(first);
    if (random.below(2) == 0) continue;
    const Time meets[] = {first.start, first.start + up_to(random, first.duration + 1ms),
                          first.end()};
    faults.push_back(any_fault(random, meets[random.below(3)]));
  }
}

}  // namespace

ChargingOptions soak_charging(std::uint64_t seed, Duration time) {
  Random random(seed);
  ChargingOptions options;
  options.faults.seed = seed;
  if (random.below(2) == 0) options.battery = BatteryPlant::lithium_48v();
  options.state_of_charge = 0.1 + 0.001 * random.below(700);
  options.ambience_celsius = 5 + static_cast<double>(random.below(25));
  if (random.below(3) == 0) options.manager_id = 1;
  if (random.below(3) == 0) options.begin = CivilTime{};
  add_faults(options.faults.faults, random, time - 2 * last_fault);
  options.faults.faults.push_back({FaultKind::not_ready, Time(time - last_fault)});
  return options;
}

void weld_contactor(ChargingNetwork& network, Duration time) {
  network.world().at(Time(time - last_fault - 2s), [&network](Time) {
    network.plant().stage.faults.stuck_ampere = welded_ampere;
  });
}

}  // namespace canvoy::charging
