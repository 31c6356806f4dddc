// A depot in virtual time: many buses of one line, each with its own seed, on all cores.
#pragma once

#include <cstdint>

#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::tools {

inline constexpr unsigned depot_threads_max = 256;

struct DepotOptions {
  bus_line::BusNetworkOptions vehicle{};  ///< of each bus, modified by depot_vehicle()
  std::uint32_t vehicles = 1;             ///< up to depot_vehicles_max
  unsigned threads = 0;                   ///< 0: one for each core
  bool json = false;
  bool require_decided = false;
};

/// Plays each vehicle to its end, or all until SIGINT, SIGTERM or SIGHUP, and prints the failed
/// vehicles and totals, with the same output for any number of threads. Returns the exit status:
/// whether all were played without a broken invariant.
int run_depot(const DepotOptions& options);

}  // namespace canvoy::tools
