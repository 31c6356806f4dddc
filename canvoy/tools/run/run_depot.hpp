// A depot in virtual time: many buses of one line, each with its own seed, on all cores.
#pragma once

#include <cstdint>

#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::tools {

inline constexpr unsigned depot_threads_max = 256;

struct DepotOptions {
  bus::BusNetworkOptions vehicle{};  ///< of each, as depot_vehicle() changes it
  std::uint32_t vehicles = 1;        ///< to depot_vehicles_max
  unsigned threads = 0;              ///< 0: one for each core
  bool json = false;
  bool require_decided = false;
};

/// Plays each vehicle until its end, or all until SIGINT, SIGTERM or SIGHUP, and prints who has
/// failed and totals: the same whatever the number of threads. The exit status: whether all were
/// played, and held.
int run_depot(const DepotOptions& options);

}  // namespace canvoy::tools
