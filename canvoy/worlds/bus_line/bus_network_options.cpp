#include "canvoy/worlds/bus_line/bus_network_options.hpp"

#include <algorithm>
#include <limits>

namespace canvoy::bus_line {

unsigned capacity_of(const BusNetworkOptions& options) {
  return std::max(1U, options.design.capacity.value_or(options.vehicle.riders.capacity));
}

BusOptions vehicle_options(const BusNetworkOptions& options) {
  constexpr unsigned behind_every = 3;
  BusOptions made = options.vehicle;
  made.seed = options.faults.seed;
  made.has_hasty_driver = made.has_hasty_driver || options.sabotage.hasty_driver;
  made.has_unkind_driver = made.has_unkind_driver || options.sabotage.unkind_driver;
  if (options.design.doors) made.doors = *options.design.doors;
  made.riders.capacity = options.design.capacity.value_or(made.riders.capacity);
  if (options.sabotage.crowd) made.riders.capacity = std::numeric_limits<unsigned>::max();
  made.riders.cars = options.design.cars;
  if (options.design.cars > 1 && made.riders.behind_every == 0) {
    made.riders.behind_every = behind_every;
  }
  return made;
}

Time end_of(const BusNetworkOptions& options) {
  constexpr Duration after_block = 10min;
  if (options.length > Duration::zero()) return Time(options.length);
  const Block& block = options.line.blocks[options.block];
  const Duration last = block.journeys.back().passings.back().arrival;
  return Time(last - start_of(block, vehicle_options(options)) + options.vehicle.late +
              after_block);
}

}  // namespace canvoy::bus_line
