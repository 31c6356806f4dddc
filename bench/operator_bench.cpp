// Cost of an operator environment with all elements at their maximum: of the start, and while
// everything on it moves. The goals are 10 ms of CPU for the start, and 5 % of a core for 10,000
// input changes per second: 5 us each.
#include <benchmark/benchmark.h>

#include "canvoy/devices/testing/operator_cabin.hpp"

namespace canvoy::operator_bench {
namespace {

using cia852::OperatorCabin;
using cia852::OperatorSettings;

/// From construction to pre-operational.
void operator_start(benchmark::State& state) {
  for (auto _ : state) {
    const OperatorCabin cabin(OperatorSettings{}.sensing_period);
    benchmark::DoNotOptimize(&cabin);
  }
}
BENCHMARK(operator_start)->Unit(benchmark::kMillisecond);

/// A second with 10,000 input changes. If they are sampled each `sensing_period`, the changes in
/// between are reported together; with zero, the hardware reports each change.
void run_changes(benchmark::State& state, Duration sensing_period) {
  OperatorCabin cabin(sensing_period);
  cabin.work();
  constexpr int changes = 10'000;
  for (auto _ : state) {
    for (int i = 0; i < changes; ++i) {
      cabin.change();
      cabin.run_to(cabin.now + std::chrono::microseconds(100));
      if (sensing_period == Duration::zero()) cabin.look();
    }
  }
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(cabin.sent), benchmark::Counter::kAvgIterations);
}

/// The usual period of 2 ms: 20 changes are reported together.
void operator_second_of_changes(benchmark::State& state) {
  run_changes(state, OperatorSettings{}.sensing_period);
}
BENCHMARK(operator_second_of_changes)->Unit(benchmark::kMillisecond);

/// Each change is reported separately.
void operator_second_of_told_changes(benchmark::State& state) {
  run_changes(state, Duration::zero());
}
BENCHMARK(operator_second_of_told_changes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace canvoy::operator_bench
