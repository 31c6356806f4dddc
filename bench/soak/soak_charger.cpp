// A campaign of a charger and a battery with faults, alone and in pairs: for each seed an hour in
// which all has to hold, and the same hour with a contactor that is welded, in which current
// outside of the handshake has to be seen. A line for each wrong verdict; exit status 0: there was
// none.
//
//     canvoy_soak_charger 200     # seeds 1 to 200
//     canvoy_soak_charger 17 17   # seed 17 alone
#include <cstdint>
#include <cstdio>

#include "canvoy/sim/charging/charging_soak.hpp"
#include "seeds.hpp"
#include "verdicts.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::charging;

/// Tells of each invariant that is broken.
bool all_hold(std::uint64_t seed) {
  ChargingNetwork network(soak_charging(seed));
  network.run_until(Time(charging_soak_time));
  bool good = true;
  for (const charging::Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    good = false;
    std::printf("seed %llu: invariant %d, fault %zu: %g where no more than %g may be\n",
                static_cast<unsigned long long>(seed), static_cast<int>(invariant.kind),
                invariant.fault, invariant.worst, invariant.allowed);
    std::fflush(stdout);
  }
  return good;
}

bool sees_a_weld(std::uint64_t seed) {
  ChargingNetwork network(soak_charging(seed));
  weld_contactor(network);
  network.run_until(Time(charging_soak_time));
  return soak::is_seen(seed, network, InvariantKind::current_outside_handshake,
                       "a welded contactor was not seen");
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_a_weld(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_charger", count, arguments, is_good);
}
