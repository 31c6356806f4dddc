// A campaign of patrols of a police car with faults, alone and in pairs: for each seed three hours
// in which all has to hold, and the same with blue flashers that give no light, which has to be
// seen. A line for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_police 200     # seeds 1 to 200
//     canvoy_soak_police 17 17   # seed 17 alone
#include <cstdint>

#include "canvoy/sim/police/police_soak.hpp"
#include "seeds.hpp"
#include "verdicts.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::police;

bool all_hold(std::uint64_t seed) {
  PoliceNetwork network(soak_police(seed));
  network.run_until(Time(police_soak_time));
  return soak::all_hold(seed, network);
}

bool sees_sabotage(std::uint64_t seed) {
  PoliceOptions options = soak_police(seed);
  darken(options);
  PoliceNetwork network(options);
  network.run_until(Time(police_soak_time));
  return soak::is_seen(seed, network, InvariantKind::blue_light,
                       "flashers without light were not seen");
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_sabotage(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_police", count, arguments, is_good);
}
