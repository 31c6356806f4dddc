#include "canvoy/sim/bus/bus_network_options.hpp"

namespace canvoy::bus {

BusOptions vehicle_options(const BusNetworkOptions& options) {
  constexpr unsigned second_car_every = 3;
  BusOptions made = options.vehicle;
  made.seed = options.faults.seed;
  if (made.riders.second_car_every == 0) made.riders.second_car_every = second_car_every;
  return made;
}

Time end_of(const BusNetworkOptions& options) {
  constexpr Duration after_block = 10min;
  if (options.length > Duration::zero()) return Time(options.length);
  const Block& block = options.line.blocks[options.block];
  const Duration last = block.journeys.back().passings.back().arrival;
  return Time(last - start_of(block, vehicle_options(options)) + after_block);
}

}  // namespace canvoy::bus
