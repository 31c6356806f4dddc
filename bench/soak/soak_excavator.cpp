// A campaign of shifts of an excavator with faults, alone and in pairs: for each seed an hour in
// which all has to hold, and the same with a lamp that gives no light, which has to be seen. A line
// for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_excavator 200     # seeds 1 to 200
//     canvoy_soak_excavator 17 17   # seed 17 alone
#include <cstdint>

#include "canvoy/sim/excavator/excavator_soak.hpp"
#include "seeds.hpp"
#include "verdicts.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::excavator;

bool all_hold(std::uint64_t seed) {
  ExcavatorNetwork network(soak_excavator(seed));
  network.run_until(Time(excavator_soak_time));
  return soak::all_hold(seed, network);
}

bool sees_sabotage(std::uint64_t seed) {
  ExcavatorOptions options = soak_excavator(seed);
  darken(options);
  ExcavatorNetwork network(options);
  network.run_until(Time(excavator_soak_time));
  return soak::is_seen(seed, network, InvariantKind::indicators,
                       "a lamp without light was not seen");
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_sabotage(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_excavator", count, arguments, is_good);
}
