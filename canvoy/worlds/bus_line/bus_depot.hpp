// A depot: many vehicles of one line, each a bus of its own with its own seed. They do not meet, so
// that each can be simulated separately, in any order.
//
//     BusNetwork network(depot_vehicle(options, 17));
//     network.run_until(network.end());
//     totals.add(report_of(network, 17));
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::bus_line {

inline constexpr std::uint32_t depot_vehicles_max = 1000;  ///< of one run

/// Options of vehicle `number`, from 1 on: its seed is that of the depot plus its number less one
/// (from 2^64 - 1 on to 0), and it drives the blocks of the line in turn.
BusNetworkOptions depot_vehicle(const BusNetworkOptions& depot, std::uint32_t number);

/// Results of a vehicle after its run.
struct VehicleReport {
  std::uint32_t number = 0;             ///< from 1
  std::uint64_t seed = 0;               ///< of its chance
  std::uint32_t block = 0;              ///< its number
  Duration length{};                    ///< of its run
  BusNetworkStatistics statistics{};    ///< counts of the run
  RiderStatistics riders{};             ///< counts of its passengers
  double odometer = 0;                  ///< m
  BusSnapshot bus{};                    ///< BusNetworkSnapshot::traffic() at the end
  std::vector<Invariant> invariants{};  ///< verdicts at the end

  /// True if no invariant is broken.
  bool all_hold() const;
};
/// The report of a network after its run, as vehicle `number`.
VehicleReport report_of(BusNetwork& network, std::uint32_t number);

/// Results of all vehicles together: the worst of each measure, the sum of each count.
struct DepotTotals {
  std::uint32_t vehicles = 0;         ///< number of them
  std::vector<std::uint32_t> failed;  ///< numbers of the vehicles, as they were added
  Duration longest{};                 ///< longest run
  BusNetworkStatistics statistics{};  ///< sums; of the delay the greatest
  RiderStatistics riders{};           ///< sums; of the people aboard the most
  double odometer = 0;                ///< m
  BusSnapshot bus;                    ///< with the highest load of any vehicle
  std::vector<Invariant> invariants;  ///< the worst of any vehicle

  /// Adds a vehicle; the order does not matter but for `failed`.
  void add(const VehicleReport& vehicle);
};

}  // namespace canvoy::bus_line
