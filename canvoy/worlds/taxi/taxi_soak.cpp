#include "canvoy/worlds/taxi/taxi_soak.hpp"

#include "canvoy/sim/soak_faults.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::uint32_t faults_max = 6;
/// At the end of the run, so that one trip is without faults.
constexpr Duration quiet = 90min;

ScheduledFault any_fault(Random& random, Time start) {
  return soak_fault<FaultKind>(random, start, device_names.size(),
                               [](std::size_t i) { return static_cast<NodeId>(i + 1); });
}

}  // namespace

TaxiOptions soak_taxi(std::uint64_t seed, Duration time) {
  Random random(seed);
  TaxiOptions options;
  options.faults.seed = seed;
  options.length = time;
  // New wheels: the meter is calibrated first.
  if (seed % 4 == 3) {
    enlarge_wheels(options);
    options.shift.calibration_metres = 1000;
  }
  options.alarm = soak_time_up_to(random, time);
  options.faults.faults = soak_faults(random, faults_max, time - quiet, any_fault);
  return options;
}

void enlarge_wheels(TaxiOptions& options) {
  options.car.wheel_circumference_m *= 1.05;
  options.shift.calibration_metres = 0;
}

}  // namespace canvoy::taxi
