#include "canvoy/worlds/charger/charger_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::charger {

namespace {

constexpr unsigned faults_max = 8;
constexpr Duration last_fault = 30s;
constexpr double welded_ampere = 30;

ScheduledFault any_fault(Random& random, Time start) {
  return soak_fault<FaultKind>(random, start);
}

}  // namespace

ChargerOptions soak_charging(std::uint64_t seed, Duration time) {
  Random random(seed);
  ChargerOptions options;
  options.faults.seed = seed;
  if (random.below(2) == 0) options.battery = BatteryPlant::lithium_48v();
  options.state_of_charge = 0.1 + 0.001 * random.below(700);
  options.ambience_celsius = 5 + static_cast<double>(random.below(25));
  if (random.below(3) == 0) options.manager_id = 1;
  if (random.below(3) == 0) options.begin = CivilTime{};
  options.faults.faults = soak_faults(random, faults_max, time - 2 * last_fault, any_fault);
  options.faults.faults.push_back({FaultKind::not_ready, Time(time - last_fault)});
  return options;
}

void weld_contactor(ChargerNetwork& network, Duration time) {
  network.world().at(Time(time - last_fault - 2s), [&network](Time) {
    network.plant().stage.faults.stuck_ampere = welded_ampere;
  });
}

}  // namespace canvoy::charger
