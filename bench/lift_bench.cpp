// Buildings with lifts: speed of the simulation relative to the clock.
#include <benchmark/benchmark.h>

#include <chrono>

#include "canvoy/worlds/lift/lift_network.hpp"

namespace canvoy::lift {
namespace {

/// Seconds of virtual time per second of this machine.
void count_speed(benchmark::State& state, Duration simulated) {
  state.counters["times_real_time"] =
      benchmark::Counter(std::chrono::duration<double>(simulated).count(),
                         benchmark::Counter::kIsIterationInvariantRate);
}

void run(benchmark::State& state, const LiftNetworkDescription& description, Duration simulated) {
  std::size_t served = 0;
  std::uint64_t frames = 0;
  for (auto _ : state) {
    LiftNetwork network(description);
    network.run_until(Time(simulated));
    if (!network.all_hold()) state.SkipWithError("an invariant did not hold");
    const LiftNetworkSnapshot end = network.snapshot();
    served = end.served;
    for (const BusSnapshot& bus : end.buses) frames += bus.frames;
  }
  count_speed(state, simulated);
  state.counters["served"] = static_cast<double>(served);
  state.counters["nodes"] = static_cast<double>(description.nodes.size());
  state.counters["buses"] = static_cast<double>(description.buses.size());
  state.SetItemsProcessed(static_cast<std::int64_t>(frames));
}

/// A controller, a drive, an encoder, two doors, and 20 panels: 19 at landings and one in the car;
/// also a light barrier and a load unit, without which no car leaves.
void one_lift(benchmark::State& state) {
  StandardLifts options{.lifts = 1, .floors = 19};
  options.lift.doors = 0b0011;
  options.population_per_floor = 20;  // more people than one lift can carry would give up
  run(state, standard_lift_network(options), 1h);
}
BENCHMARK(one_lift)->Unit(benchmark::kMillisecond);

/// 857 nodes on nine buses.
void eight_lifts_of_100_floors(benchmark::State& state) {
  run(state, standard_lift_network({.lifts = 8, .floors = 100}), 10min);
}
BENCHMARK(eight_lifts_of_100_floors)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace canvoy::lift
