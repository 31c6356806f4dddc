// A campaign of days of a bus with faults, alone and in pairs: for each seed two hours
// in which all has to hold, and the same with a destination indicator that does not change, which
// has to be seen. A line for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_bus 200     # seeds 1 to 200
//     canvoy_soak_bus 17 17   # seed 17 alone
#include <cstdint>

#include "canvoy/sim/bus/bus_soak.hpp"
#include "seeds.hpp"
#include "verdicts.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::bus;

bool all_hold(std::uint64_t seed) {
  BusNetwork network(soak_bus(seed));
  network.run_until(Time(bus_soak_time));
  return soak::all_hold(seed, network);
}

bool sees_sabotage(std::uint64_t seed) {
  BusNetworkOptions options = soak_bus(seed);
  freeze(options);
  BusNetwork network(options);
  network.run_until(Time(bus_soak_time));
  return soak::is_seen(seed, network, InvariantKind::lie,
                       "a destination that does not change was not seen");
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_sabotage(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_bus", count, arguments, is_good);
}
