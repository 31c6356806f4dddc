// What a simulated world costs: its network alone, from power-on, without a log or a picture. In
// instructions (bench/run) it does not depend on what else the machine does.
#include <benchmark/benchmark.h>

#include "canvoy/worlds/bus_line/bus_network.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/police/police_network.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::world_bench {

/// What is counted: a function of its own, so that bench/run finds it.
template <class Network>
[[gnu::noinline]] void play(Network& network, Duration time) {
  network.run_until(Time(time));
}

template <class Network, class Options>
void world(benchmark::State& state, Duration time) {
  Options options;
  options.length = time;
  for (auto _ : state) {
    Network network(options);
    play(network, time);
  }
}

void hour_of_a_taxi(benchmark::State& state) {
  world<taxi::TaxiNetwork, taxi::TaxiOptions>(state, 1h);
}
BENCHMARK(hour_of_a_taxi)->Name("world/hour_of_a_taxi")->Unit(benchmark::kMillisecond);

void hour_of_a_bus(benchmark::State& state) {
  world<bus_line::BusNetwork, bus_line::BusNetworkOptions>(state, 1h);
}
BENCHMARK(hour_of_a_bus)->Name("world/hour_of_a_bus")->Unit(benchmark::kMillisecond);

void hour_of_a_police_car(benchmark::State& state) {
  world<police::PoliceNetwork, police::PoliceOptions>(state, 1h);
}
BENCHMARK(hour_of_a_police_car)->Name("world/hour_of_a_police_car")->Unit(benchmark::kMillisecond);

void minutes_of_an_excavator(benchmark::State& state) {
  world<excavator::ExcavatorNetwork, excavator::ExcavatorOptions>(state, 5min);
}
BENCHMARK(minutes_of_an_excavator)
    ->Name("world/five_minutes_of_an_excavator")
    ->Unit(benchmark::kMillisecond);

}  // namespace canvoy::world_bench
