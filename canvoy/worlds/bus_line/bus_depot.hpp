// A depot: many vehicles of one line, each a bus of its own with its own seed, simulated
// separately, in any order. They do not meet, but share the people at their stops where they follow
// each other at short times: each knows when the one ahead has left, from a day without devices
// (LineDay).
//
//     BusNetwork network(depot_vehicle(options, 17));
//     network.run_until(network.end());
//     totals.add(report_of(network, 17));
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "canvoy/worlds/bus_line/bus_network.hpp"
#include "canvoy/worlds/bus_line/line_day.hpp"

namespace canvoy::bus_line {

inline constexpr std::uint32_t depot_vehicles_max = 1000;  ///< of one run

/// Options of vehicle `number`, from 1 on: its seed is that of the depot plus its number less one
/// (from 2^64 - 1 on to 0), and it drives the blocks of the line in turn.
BusNetworkOptions depot_vehicle(const BusNetworkOptions& depot, std::uint32_t number);

/// End of the run of a vehicle, as time of the day of service.
Duration last_time_of(const BusNetworkOptions& vehicle);
/// The day of all blocks of the line of a vehicle until then, with the seeds that they have in its
/// depot; null where vehicles do not follow each other at short times.
std::shared_ptr<const LineDay> line_day_of(const BusNetworkOptions& vehicle, Duration until);
/// Number from 0 of the day that a vehicle of a depot belongs to: each has one vehicle of each
/// block.
std::size_t day_of(const BusNetworkOptions& depot, std::uint32_t number);
/// Lets people at the stops of a vehicle come since the vehicle ahead has left on this day; null:
/// by the timetable.
void share_people(BusNetworkOptions& vehicle, std::shared_ptr<const LineDay> day);

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
