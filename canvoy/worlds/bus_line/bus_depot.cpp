#include "canvoy/worlds/bus_line/bus_depot.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::bus_line {

namespace {

void add_statistics(BusNetworkStatistics& sum, const BusNetworkStatistics& more) {
  sum.journeys += more.journeys;
  sum.stops += more.stops;
  sum.announced += more.announced;
  sum.texts += more.texts;
  sum.headways.add(more.headways);
  sum.worst_delay = std::max(sum.worst_delay, more.worst_delay);
}

void add_riders(RiderStatistics& sum, const RiderStatistics& more) {
  sum.came += more.came;
  sum.in += more.in;
  sum.out += more.out;
  sum.left_behind += more.left_behind;
  sum.carried_past += more.carried_past;
  sum.bought += more.bought;
  sum.cancelled += more.cancelled;
  sum.without_ticket += more.without_ticket;
  sum.aboard_max = std::max(sum.aboard_max, more.aboard_max);
}

void add_verdict(Invariant& worst, const Invariant& more) {
  check_invariant(worst.kind == more.kind);
  worst.held = worst.held && more.held;
  worst.worst = std::max(worst.worst, more.worst);
  worst.judged += more.judged;
}

}  // namespace

BusNetworkOptions depot_vehicle(const BusNetworkOptions& depot, std::uint32_t number) {
  BusNetworkOptions options = depot;
  options.faults.seed += number - 1;
  options.block = (number - 1) % depot.line.blocks.size();
  return options;
}

std::size_t day_of(const BusNetworkOptions& depot, std::uint32_t number) {
  return (number - 1) / depot.line.blocks.size();
}

Duration last_time_of(const BusNetworkOptions& vehicle) {
  const Block& block = vehicle.line.blocks[vehicle.block];
  return start_of(block, vehicle_options(vehicle)) + (end_of(vehicle) - Time{});
}

std::shared_ptr<const LineDay> line_day_of(const BusNetworkOptions& vehicle, Duration until) {
  if (!LineDay::is_frequent(vehicle.line)) return nullptr;
  std::vector<BusOptions> all;
  for (std::size_t block = 0; block < vehicle.line.blocks.size(); ++block) {
    all.push_back(vehicle_options(vehicle));
    all.back().seed += block - vehicle.block;
  }
  return std::make_shared<const LineDay>(vehicle.line, std::move(all), until);
}

void share_people(BusNetworkOptions& vehicle, std::shared_ptr<const LineDay> day) {
  if (day == nullptr) return;
  vehicle.vehicle.riders.ahead = [day = std::move(day), block = vehicle.block](
                                     std::uint32_t journey, std::size_t stop) {
    return day->ahead(block, journey, stop);
  };
}

bool VehicleReport::all_hold() const {
  return std::ranges::all_of(invariants, &Invariant::held);
}

VehicleReport report_of(BusNetwork& network, std::uint32_t number) {
  const BusNetworkSnapshot end = network.snapshot();
  return {.number = number,
          .seed = network.options().faults.seed,
          .block = end.truth.block->number,
          .length = end.at - Time{},
          .statistics = end.statistics,
          .riders = end.riders,
          .odometer = end.odometer,
          .bus = end.traffic(),
          .invariants = network.invariants()};
}

void DepotTotals::add(const VehicleReport& vehicle) {
  ++vehicles;
  if (!vehicle.all_hold()) failed.push_back(vehicle.number);
  longest = std::max(longest, vehicle.length);
  add_statistics(statistics, vehicle.statistics);
  add_riders(riders, vehicle.riders);
  odometer += vehicle.odometer;
  bus.load = std::max(bus.load, vehicle.bus.load);
  bus.frames += vehicle.bus.frames;
  bus.error_frames += vehicle.bus.error_frames;
  if (invariants.empty()) {
    invariants = vehicle.invariants;
    return;
  }
  check_invariant(invariants.size() == vehicle.invariants.size());
  for (std::size_t i = 0; i < invariants.size(); ++i) {
    add_verdict(invariants[i], vehicle.invariants[i]);
  }
}

}  // namespace canvoy::bus_line
