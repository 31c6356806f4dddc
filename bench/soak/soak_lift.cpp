// A campaign of lifts with faults: for each seed an hour of a building with people and one fault
// after the other, and an hour in which two faults meet each time. A line for each invariant that
// was broken; exit status 0: none was.
//
//     canvoy_soak_lift 1000       # seeds 1 to 1000
//     canvoy_soak_lift 17 17      # seed 17 alone
#include <cstdint>
#include <cstdio>

#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_soak.hpp"
#include "seeds.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::lift;

/// Tells of each invariant that is broken.
bool all_hold(std::uint64_t seed, const char* faults, const LiftNetworkDescription& description) {
  LiftNetwork network(description);
  network.run_until(Time(soak_time));
  bool good = true;
  for (const lift::Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    good = false;
    std::printf(
        "seed %llu, %s: invariant %d of lift %d, fault %lld: %g where no more than %g may be\n",
        static_cast<unsigned long long>(seed), faults, static_cast<int>(invariant.kind),
        invariant.part, invariant.fault == no_fault ? -1 : static_cast<long long>(invariant.fault),
        invariant.worst, invariant.allowed);
    std::fflush(stdout);
  }
  return good;
}

bool is_good(std::uint64_t seed) {
  const bool alone = all_hold(seed, "faults", soak_network(seed));
  return all_hold(seed, "pairs of faults", soak_network_of_pairs(seed)) && alone;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_lift", count, arguments, is_good);
}
