// A depot: many vehicles of one line, each a bus of its own with its own seed. They do not meet, so
// that each can be played for itself, in any order.
//
//     BusNetwork network(depot_vehicle(options, 17));
//     network.run_until(network.end());
//     totals.add(report_of(network, 17));
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus {

inline constexpr std::uint32_t depot_vehicles_max = 1000;

/// Of vehicle `number`, from 1 on: it has the seed of the depot plus its number less one (from
/// 2^64 - 1 on to 0), and drives the blocks of the line in turn.
BusNetworkOptions depot_vehicle(const BusNetworkOptions& depot, std::uint32_t number);

/// What is left of a vehicle when it has run.
struct VehicleReport {
  std::uint32_t number = 0;
  std::uint64_t seed = 0;
  std::uint32_t block = 0;  ///< its number
  Duration length{};
  BusNetworkStatistics statistics{};
  RiderStatistics riders{};
  double odometer = 0;  ///< m
  BusSnapshot bus{};
  std::vector<Invariant> invariants{};

  bool all_hold() const;
};
VehicleReport report_of(BusNetwork& network, std::uint32_t number);

/// Of all vehicles together; the worst of what is measured, the sum of what is counted.
struct DepotTotals {
  std::uint32_t vehicles = 0;
  std::vector<std::uint32_t> failed;  ///< their numbers, as they were added
  Duration longest{};
  BusNetworkStatistics statistics{};
  RiderStatistics riders{};
  double odometer = 0;                ///< m
  BusSnapshot bus;                    ///< its load is the highest one
  std::vector<Invariant> invariants;  ///< the worst of any one vehicle

  void add(const VehicleReport& vehicle);
};

}  // namespace canvoy::bus
