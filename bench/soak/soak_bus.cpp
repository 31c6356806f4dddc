// A campaign of days of a bus with faults, alone and in pairs: for each seed two hours
// in which all has to hold, and the same with a destination indicator that does not change, which
// has to be seen. A line for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_bus 200     # seeds 1 to 200
//     canvoy_soak_bus 17 17   # seed 17 alone
#include <cstdint>
#include <cstdio>

#include "canvoy/sim/bus/bus_soak.hpp"
#include "seeds.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::bus;

/// Tells of each invariant that is broken.
bool all_hold(std::uint64_t seed) {
  BusNetwork network(soak_bus(seed));
  network.run_until(Time(bus_soak_time));
  bool good = true;
  for (const bus::Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    good = false;
    std::printf("seed %llu: %s: %g where no more than %g may be\n",
                static_cast<unsigned long long>(seed), invariant_name(invariant.kind).name.data(),
                invariant.worst, invariant.allowed);
    std::fflush(stdout);
  }
  return good;
}

bool sees_frozen_destination(std::uint64_t seed) {
  BusNetworkOptions options = soak_bus(seed);
  freeze(options);
  BusNetwork network(options);
  network.run_until(Time(bus_soak_time));
  for (const bus::Invariant& invariant : network.invariants()) {
    if (invariant.kind == InvariantKind::lie && !invariant.held) return true;
  }
  std::printf("seed %llu: a destination that does not change was not seen\n",
              static_cast<unsigned long long>(seed));
  return false;
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_frozen_destination(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_bus", count, arguments, is_good);
}
