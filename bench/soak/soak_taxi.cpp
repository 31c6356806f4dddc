// A campaign of shifts of a taxi with faults, alone and in pairs: for each seed three hours in
// which all has to hold, and the same with wheels that are larger than the meter believes, which
// has to be seen. A line for each wrong verdict; exit status 0: there was none.
//
//     canvoy_soak_taxi 200     # seeds 1 to 200
//     canvoy_soak_taxi 17 17   # seed 17 alone
#include <cstdint>

#include "canvoy/sim/taxi/taxi_soak.hpp"
#include "seeds.hpp"
#include "verdicts.hpp"

namespace {

using namespace canvoy;
using namespace canvoy::taxi;

bool all_hold(std::uint64_t seed) {
  TaxiNetwork network(soak_taxi(seed));
  network.run_until(Time(taxi_soak_time));
  return soak::all_hold(seed, network);
}

bool sees_sabotage(std::uint64_t seed) {
  TaxiOptions options = soak_taxi(seed);
  enlarge_wheels(options);
  TaxiNetwork network(options);
  network.run_until(Time(taxi_soak_time));
  return soak::is_seen(seed, network, InvariantKind::distance,
                       "wheels that are too large were not seen");
}

bool is_good(std::uint64_t seed) {
  const bool holds = all_hold(seed);
  return sees_sabotage(seed) && holds;
}

}  // namespace

int main(int count, char** arguments) {
  return soak::run_seeds("canvoy_soak_taxi", count, arguments, is_good);
}
