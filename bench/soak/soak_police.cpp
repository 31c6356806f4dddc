// A campaign of patrols of a police car with faults, alone and in pairs: for each seed three hours
// in which all has to hold, and the same with blue flashers that give no light, which has to be
// seen. A line for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_police 200     # seeds 1 to 200
//     canvoy_soak_police 17 17   # seed 17 alone
#include <cstdint>
#include <cstdio>

#include "canvoy/sim/police/police_soak.hpp"
#include "seeds.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::police;

/// Tells of each invariant that is broken.
bool all_hold(std::uint64_t seed) {
  PoliceNetwork network(soak_police(seed));
  network.run_until(Time(police_soak_time));
  bool good = true;
  for (const police::Invariant& invariant : network.invariants()) {
    if (invariant.held) continue;
    good = false;
    std::printf("seed %llu: %s: %g where no more than %g may be\n",
                static_cast<unsigned long long>(seed), invariant_name(invariant.kind).name.data(),
                invariant.worst, invariant.allowed);
    std::fflush(stdout);
  }
  return good;
}

bool sees_dark_flashers(std::uint64_t seed) {
  PoliceOptions options = soak_police(seed);
  darken(options);
  PoliceNetwork network(options);
  network.run_until(Time(police_soak_time));
  for (const police::Invariant& invariant : network.invariants()) {
    if (invariant.kind == InvariantKind::blue_light && !invariant.held) return true;
  }
  std::printf("seed %llu: flashers without light were not seen\n",
              static_cast<unsigned long long>(seed));
  return false;
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_dark_flashers(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_police", count, arguments, is_good);
}
